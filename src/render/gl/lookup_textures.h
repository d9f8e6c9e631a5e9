#pragma once
#include <vector>

#include "render/gl/lookup_resources.h"

namespace havs {

/// What the plan's shaders read besides the segment: the textures of its resources.
class LookupTextures {
 public:
  /// Throws Error{running} (no memory, beyond the context's limits).
  LookupTextures(const PreparedScene& prepared, const RenderPlan& plan, const Progress& progress);
  /// Binds the textures, from unit 0 on, and sets the uniforms of lookup/*.glsl, curve.glsl and opaque_surfaces.glsl.
  void bind(const Program& program) const;

 private:
  std::vector<ResourceTextures> resources_;
};

}  // namespace havs
