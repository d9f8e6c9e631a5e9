#include "render/gl/layer_buffers.h"

#include "core/error.h"
#include "gl/limits.h"

namespace havs {
namespace {

constexpr GLuint kBeginsBinding = 4, kDistancesBinding = 5, kColorsBinding = 6;  // as in layers.glsl

template <class Part>
auto partsOf(const RayLayers& layers, const Part& part) {
  std::vector<std::decay_t<decltype(part(layers.layers[0]))>> parts;
  parts.reserve(layers.layers.size());
  for (const RayLayer& layer : layers.layers) parts.push_back(part(layer));
  return parts;
}

const RayLayers& checked(const RayLayers& layers) {
  const auto most = static_cast<std::size_t>(limits().storageBlock);
  if (layers.layers.size() * sizeof(RayLayer::rgba) > most || layers.begin.size() * sizeof(std::uint32_t) > most)
    failRunning("the layers of the boundary are more than this OpenGL lets a shader see", "",
                "draw a smaller picture, or with --device native");
  return layers;
}

}  // namespace

LayerBuffers::LayerBuffers(const RayLayers& layers)
    : width_(checked(layers).width),
      height_(layers.height),
      begins_(Buffer::of("begins of layers", layers.begin)),
      distances_(Buffer::of("distances of layers",
                            partsOf(layers, [](const RayLayer& layer) { return static_cast<float>(layer.distance); }))),
      colors_(Buffer::of("colours of layers", partsOf(layers, [](const RayLayer& layer) { return layer.rgba; }))) {}

void LayerBuffers::bind(const Program& program, const Tile& tile) const {
  begins_.bindBase(GL_SHADER_STORAGE_BUFFER, kBeginsBinding);
  distances_.bindBase(GL_SHADER_STORAGE_BUFFER, kDistancesBinding);
  colors_.bindBase(GL_SHADER_STORAGE_BUFFER, kColorsBinding);
  program.set("layerCorner", glm::ivec2(tile.x, height_ - 1 - tile.y));
  program.set("layerRowLength", width_);
}

}  // namespace havs
