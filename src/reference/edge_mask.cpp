// Every boundary edge is clipped at the eye plane, projected, and walked along its longer screen axis; the few pixels
// beside it in each column (or row) are tested by their true distance.
#include "reference/edge_mask.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <utility>

#include "core/parallel.h"

namespace havs {
namespace {

/// Edges nearer to the eye plane than this (in local units) are cut off: what is left out shows beyond any picture's
/// border.
constexpr double kNear = 1e-6;

double distanceToSegment(const Vec2& p, const Vec2& a, const Vec2& b) {
  const Vec2 along = b - a;
  const double squared = dot(along, along);
  const double t = squared > 0 ? std::clamp(dot(p - a, along) / squared, 0.0, 1.0) : 0.0;
  return length(p - (a + t * along));
}

/// The pixels of 0 .. size - 1 whose centres lie in [low, high]; empty where first > second.
std::pair<int, int> centresBetween(double low, double high, int size) {
  const double last = size - 1;
  return {static_cast<int>(std::ceil(std::clamp(low - 0.5, 0.0, last + 1))),
          static_cast<int>(std::floor(std::clamp(high - 0.5, -1.0, last)))};
}

class EdgeMarker {
 public:
  EdgeMarker(const View& view, double distance, std::vector<unsigned char>& mask)
      : view_(view), distance_(distance), mask_(mask) {}

  void mark(Vec3 p, Vec3 q) const {
    if (!view_.orthographic && !clipAtEyePlane(p, q)) return;
    const Vec3 a = view_.project(p), b = view_.project(q);
    markSegment(Vec2(a), Vec2(b));
  }

 private:
  bool clipAtEyePlane(Vec3& p, Vec3& q) const {
    double zp = dot(view_.forward, p - view_.eye), zq = dot(view_.forward, q - view_.eye);
    if (zp < zq) {
      std::swap(zp, zq);
      std::swap(p, q);
    }
    if (zp < kNear) return false;
    if (zq < kNear) q = p + (q - p) * ((zp - kNear) / (zp - zq));
    return true;
  }

  void markSegment(const Vec2& a, const Vec2& b) const {
    const std::array<int, 2> size{view_.width, view_.height};
    const int along = std::abs(b.x - a.x) >= std::abs(b.y - a.y) ? 0 : 1;
    const int across = 1 - along;
    const double extent = b[along] - a[along];
    auto acrossAt = [&](double position) {
      const double t = extent != 0 ? std::clamp((position - a[along]) / extent, 0.0, 1.0) : 0.0;
      return a[across] + t * (b[across] - a[across]);
    };
    const auto [first, last] =
        centresBetween(std::min(a[along], b[along]) - distance_, std::max(a[along], b[along]) + distance_,
                       size[static_cast<std::size_t>(along)]);
    for (int i = first; i <= last; ++i) {
      const double centre = i + 0.5;
      const double one = acrossAt(centre - distance_), other = acrossAt(centre + distance_);
      const auto [low, high] = centresBetween(std::min(one, other) - distance_, std::max(one, other) + distance_,
                                              size[static_cast<std::size_t>(across)]);
      for (int j = low; j <= high; ++j) {
        const int x = along == 0 ? i : j, y = along == 0 ? j : i;
        if (distanceToSegment({x + 0.5, y + 0.5}, a, b) <= distance_) markPixel(x, y);
      }
    }
  }

  /// Several threads may mark one pixel.
  void markPixel(int x, int y) const {
    const auto pixel =
        static_cast<std::size_t>(y) * static_cast<std::size_t>(view_.width) + static_cast<std::size_t>(x);
    std::atomic_ref(mask_[pixel]).store(1, std::memory_order_relaxed);
  }

  const View& view_;
  double distance_;
  std::vector<unsigned char>& mask_;
};

}  // namespace

std::vector<unsigned char> boundaryEdgeMask(std::span<const Vec3> localPoints, const Faces& faces, const View& view,
                                            double distance) {
  std::vector<unsigned char> mask(static_cast<std::size_t>(view.width) * static_cast<std::size_t>(view.height), 0);
  const EdgeMarker marker(view, distance, mask);
  parallelFor(0, faces.size(), 1024, [&](std::size_t f) {
    if (!faces.isBoundary(f)) return;
    const auto& vertices = faces.vertices[f];
    for (std::size_t i = 0; i < 3; ++i) {
      const Index from = vertices[i], to = vertices[(i + 1) % 3];
      // The boundary is closed: each edge is run through as often in one direction as in the other.
      if (from < to) marker.mark(localPoints[from], localPoints[to]);
    }
  });
  return mask;
}

}  // namespace havs
