#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "scene/view.h"

namespace havs {

/// Something thin that a ray meets besides the volume.
struct RayLayer {
  double distance;            ///< along the ray, local units, as fragments have it: from where its depth is 0
  std::array<float, 4> rgba;  ///< premultiplied
};

/// The layers of every pixel's ray of one view, near first. A layer is composited before the first segment drawn of the
/// ray whose middle lies behind it, so it is always between two segments: on a face of the mesh, where it belongs,
/// whatever the rounding of either's distance.
struct RayLayers {
  int width = 0, height = 0;
  std::vector<std::uint32_t> begin;  ///< of each pixel in `layers`, row 0 on top; one more at the end
  std::vector<RayLayer> layers;

  std::size_t pixel(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
  }
  std::span<const RayLayer> at(int x, int y) const {
    const std::size_t p = pixel(x, y);
    return {layers.data() + begin[p], layers.data() + begin[p + 1]};
  }
};

/// Those of one ray, taken in order.
class LayersOfRay {
 public:
  explicit LayersOfRay(std::span<const RayLayer> layers) : left_(layers) {}
  /// take(rgba) of those nearer than `distance` that have not been taken.
  template <class Take>
  void before(double distance, const Take& take) {
    for (; !left_.empty() && left_.front().distance < distance; left_ = left_.subspan(1)) take(left_.front().rgba);
  }
  template <class Take>
  void rest(const Take& take) {
    for (const RayLayer& layer : left_) take(layer.rgba);
    left_ = {};
  }

 private:
  std::span<const RayLayer> left_;
};

/// The same where the local frame has been moved to have its origin there, on the view's axis (scene/eye_cut.h).
RayLayers seenFrom(RayLayers layers, const View& view, const Vec3& origin);

}  // namespace havs
