#include "render/gl/drawing_steps.h"

#include <algorithm>
#include <glm/gtc/type_ptr.hpp>

namespace havs {

ShaderOptions shaderOptions(const RenderPlan& plan) {
  ShaderOptions options;
  for (const ShaderDefine& define : plan.defines) options.defines[define.name] = define.value;
  options.standsFor["lookup.glsl"] = plan.lookup.shader;
  if (!plan.ordering.empty()) options.extensions = {plan.ordering};
  return options;
}

const Program& programOf(ProgramCache& programs, const RenderPlan& plan, const std::string& role) {
  const PlannedProgram& planned = programOf(plan, role);
  return programs.get(planned.vertex, planned.fragment, planned.options);
}

Image emptyPicture(const View& view) {
  Image image{view.width, view.height, {}};
  image.rgba.resize(std::size_t{4} * static_cast<std::size_t>(view.width) * static_cast<std::size_t>(view.height));
  return image;
}

void useForView(const Program& program, const View& view, const Tile& tile) {
  program.use();
  program.set("toClip", glm::mat4(clipMatrix(view, tile)));
  program.set("forward", glm::vec3(view.forward));
  program.set("pixelToRay", glm::vec4(pixelToRay(view, tile)));
}

void readTile(const Framebuffer& framebuffer, const Tile& tile, Image& image) {
  const int top = image.height - tile.y - tile.height;
  framebuffer.readInto(image.pixel(tile.x, top), 0, tile.width, tile.height, image.width);
  for (int low = top, high = top + tile.height - 1; low < high; ++low, --high) {
    float* const row = image.pixel(tile.x, low);
    std::swap_ranges(row, row + std::size_t{4} * static_cast<std::size_t>(tile.width), image.pixel(tile.x, high));
  }
}

}  // namespace havs
