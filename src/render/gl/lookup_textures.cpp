#include "render/gl/lookup_textures.h"

namespace havs {

LookupTextures::LookupTextures(const PreparedScene& prepared, const RenderPlan& plan, const Progress& progress) {
  const ExtinctionCurve seen = withoutOpaque(prepared.curve);
  for (const LookupResource& resource : plan.resources)
    resources_.push_back(resource.make({prepared, seen, plan, progress}));
}

void LookupTextures::bind(const Program& program) const {
  GLuint unit = 0;
  for (const ResourceTextures& resource : resources_) {
    for (const auto& [name, texture] : resource.samplers) {
      texture.bind(unit);
      program.set(name.c_str(), static_cast<int>(unit++));
    }
    for (const auto& [name, value] : resource.uniforms)
      std::visit([&, &uniform = name](const auto& v) { program.set(uniform.c_str(), v); }, value);
  }
}

}  // namespace havs
