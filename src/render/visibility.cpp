#include "render/visibility.h"

#include "core/find_row.h"
#include "render/gl/renderers.h"

namespace havs {

std::span<const VisibilityMethod> visibilityMethods() {
  static const std::vector<VisibilityMethod> rows{
      {.name = "kbuffer",
       .description = "k nearest fragments of a pixel in render targets (Callahan et al. 2005)",
       .extensions = {"GL_EXT_shader_framebuffer_fetch"},
       .needsOrder = true,
       .maximumK = 14,
       .carriesColors = true,
       .plan = planKBuffer,
       .make = makeKBufferRenderer},
  };
  return rows;
}

const VisibilityMethod& visibilityMethod(const std::string& name) {
  return findRow(visibilityMethods(), name, "visibility method");
}

}  // namespace havs
