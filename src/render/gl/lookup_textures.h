#pragma once
#include <map>
#include <string>
#include <variant>
#include <vector>

#include "gl/buffer.h"
#include "gl/program.h"
#include "gl/texture.h"
#include "render/lookup_resources.h"

namespace havs {

/// What the plan's shaders read besides the segment: its resources as textures and uniforms.
class LookupTextures {
 public:
  /// Throws Error{running} (no memory, beyond the context's limits).
  LookupTextures(const PreparedScene& prepared, const RenderPlan& plan, const Progress& progress);
  /// Binds the textures, from unit 0 on, and sets the uniforms of lookup/*.glsl, curve.glsl, filter.glsl and
  /// opaque_surfaces.glsl.
  void bind(const Program& program) const;

 private:
  void addTexels(const std::string& name, const ResourceTable& table);
  void addFiltered(const std::string& name, const ResourceTable& table, const TableFormat& format);

  std::map<std::string, Texture> samplers_;
  std::map<std::string, std::variant<int, float, glm::vec3>> uniforms_;
  std::map<std::string, std::vector<float>> rows_;
  std::vector<Buffer> buffers_;  // that buffer textures look at
};

}  // namespace havs
