#include "scene/view.h"

#include <cmath>

namespace havs {

Vec3 View::project(const Vec3& p) const {
  const Vec3 q = p - center;
  const double along = dot(forward, p - eye);
  const double scale = orthographic ? 1.0 : along;
  const double u = dot(right, q) / (halfWidth * scale);
  const double v = dot(up, q) / (halfHeight * scale);
  return {0.5 * (u + 1.0) * width, 0.5 * (1.0 - v) * height, orthographic ? depth(p) : along};
}

double View::rayScale(double pixelX, double pixelY) const {
  if (orthographic) return 1.0;
  const double x = (2.0 * pixelX / width - 1.0) * halfWidth;
  const double y = (1.0 - 2.0 * pixelY / height) * halfHeight;
  return std::sqrt(1.0 + x * x + y * y);
}

}  // namespace havs
