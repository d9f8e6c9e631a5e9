#pragma once
#include <optional>

#include "core/progress.h"
#include "gl/program.h"
#include "gl/texture.h"
#include "render/plan.h"
#include "scene/prepared_scene.h"

namespace havs {

/// What the plan's lookup reads, in textures: the pre-integrated table, the sampled transfer function, the opaque
/// intervals - each only where the plan needs it.
class LookupTextures {
 public:
  LookupTextures(const PreparedScene& prepared, const RenderPlan& plan, const Progress& progress);
  /// Binds the textures and sets the uniforms of lookup/*.glsl, curve.glsl and opaque_surfaces.glsl.
  void bind(const Program& program) const;

 private:
  void makeTable(const ExtinctionCurve& seen, double longestEdge, const RenderPlan& plan, const Progress& progress);
  void makeCurve(const ExtinctionCurve& curve, const ExtinctionCurve& seen);
  void makeOpaque(const ExtinctionCurve& curve);

  std::optional<Texture> table_, curve_, opaque_;
  float lengthScale_ = 0;
};

}  // namespace havs
