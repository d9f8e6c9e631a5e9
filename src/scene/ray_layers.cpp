#include "scene/ray_layers.h"

namespace havs {

RayLayers seenFromOrigin(RayLayers layers, const View& view) {
  const double depthOfEye = view.depth(view.eye);
  for (int y = 0; y < layers.height; ++y)
    for (int x = 0; x < layers.width; ++x) {
      const double moved = depthOfEye * view.rayScale(x + 0.5, y + 0.5);
      const std::size_t pixel = layers.pixel(x, y);
      for (std::uint32_t i = layers.begin[pixel]; i < layers.begin[pixel + 1]; ++i) layers.layers[i].distance -= moved;
    }
  return layers;
}

}  // namespace havs
