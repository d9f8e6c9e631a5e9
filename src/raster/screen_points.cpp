#include "raster/screen_points.h"

#include <algorithm>
#include <cmath>

#include "core/parallel.h"
#include "raster/exact_sum.h"

namespace havs {
namespace {

/// Below it coordinates count as 0, so that no product of the fill rule underflows.
constexpr double kLeast = 1e-100;

double flushed(double value) { return std::abs(value) < kLeast ? 0.0 : value; }

struct Interval {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();
  void include(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
};

/// Where the part of the edge from `front` (w > 0) to `behind` (w <= 0) before the eye goes to as it nears the eye
/// plane: to minus or plus infinity, by the sign of the coordinate there. Both where rounding hides it.
void includeCrossing(Interval& interval, double front, double frontW, double behind, double behindW) {
  constexpr double kRounding = 1e-14;
  const double a = -front * behindW, b = behind * frontW;
  const double margin = kRounding * (std::abs(a) + std::abs(b));
  if (a + b <= margin) interval.low = -std::numeric_limits<double>::infinity();
  if (a + b >= -margin) interval.high = std::numeric_limits<double>::infinity();
}

/// First and last of the pixels 0 .. size - 1 whose centres lie in the interval, which is widened a little for the
/// rounding of the divisions.
std::array<int, 2> pixelsIn(const Interval& interval, int size) {
  constexpr double kMargin = 1e-6;
  const double first = std::clamp(std::ceil(interval.low - 0.5 - kMargin), 0.0, static_cast<double>(size));
  const double last = std::clamp(std::floor(interval.high - 0.5 + kMargin), -1.0, size - 1.0);
  return {static_cast<int>(first), static_cast<int>(last)};
}

}  // namespace

ScreenPoint screenPoint(const Vec3& localPoint, const View& view) {
  const Vec3 q = localPoint - view.center;
  const double w = view.orthographic ? 1.0 : dot(view.forward, localPoint - view.eye);
  const double u = dot(view.right, q) / view.halfWidth;
  const double v = dot(view.up, q) / view.halfHeight;
  return {flushed(0.5 * (w + u) * view.width), flushed(0.5 * (w - v) * view.height), flushed(w),
          view.depth(localPoint)};
}

std::vector<ScreenPoint> screenPoints(std::span<const Vec3> localPoints, const View& view) {
  std::vector<ScreenPoint> points(localPoints.size());
  parallelFor(0, points.size(), 8192, [&](std::size_t i) { points[i] = screenPoint(localPoints[i], view); });
  return points;
}

int sideOfEye(const Vec3& a, const Vec3& b, const Vec3& c, const View& view) {
  const ScreenPoint p = screenPoint(a, view), q = screenPoint(b, view), r = screenPoint(c, view);
  ExactSum<24> determinant;  // six products of three, four parts each
  determinant.addProduct(p.x, q.y, r.w);
  determinant.addProduct(-p.x, q.w, r.y);
  determinant.addProduct(p.y, q.w, r.x);
  determinant.addProduct(-p.y, q.x, r.w);
  determinant.addProduct(p.w, q.x, r.y);
  determinant.addProduct(-p.w, q.y, r.x);
  const double value = determinant.value();
  return value > 0 ? -1 : value < 0 ? 1 : 0;
}

PixelBox intersection(const PixelBox& a, const PixelBox& b) {
  return {std::max(a.left, b.left), std::max(a.top, b.top), std::min(a.right, b.right), std::min(a.bottom, b.bottom)};
}

PixelBox boxOf(const std::array<ScreenPoint, 4>& corners, int width, int height) {
  Interval x, y;
  for (const ScreenPoint& front : corners) {
    if (!(front.w > 0)) continue;
    x.include(front.x / front.w);
    y.include(front.y / front.w);
    for (const ScreenPoint& behind : corners) {
      if (behind.w > 0) continue;
      includeCrossing(x, front.x, front.w, behind.x, behind.w);
      includeCrossing(y, front.y, front.w, behind.y, behind.w);
    }
  }
  const auto [left, right] = pixelsIn(x, width);
  const auto [top, bottom] = pixelsIn(y, height);
  return {left, top, right, bottom};
}

}  // namespace havs
