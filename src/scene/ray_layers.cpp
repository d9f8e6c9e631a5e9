#include "scene/ray_layers.h"

namespace havs {

RayLayers seenFrom(RayLayers layers, const View& view, const Vec3& origin) {
  const double depth = view.depth(origin);
  for (int y = 0; y < layers.height; ++y)
    for (int x = 0; x < layers.width; ++x) {
      const double moved = depth * view.rayScale(x + 0.5, y + 0.5);
      const std::size_t pixel = layers.pixel(x, y);
      for (std::uint32_t i = layers.begin[pixel]; i < layers.begin[pixel + 1]; ++i) layers.layers[i].distance -= moved;
    }
  return layers;
}

}  // namespace havs
