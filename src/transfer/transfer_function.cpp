#include "transfer/transfer_function.h"

#include <algorithm>

#include "transfer/interpolate.h"

namespace havs {

ControlPoint evaluate(const TransferFunction& function, double scalar) {
  const auto& points = function.points;
  const auto above = std::upper_bound(points.begin(), points.end(), scalar,
                                      [](double value, const ControlPoint& p) { return value < p.scalar; });
  ControlPoint result = above == points.begin() ? points.front() : *std::prev(above);
  if (above != points.begin() && above != points.end()) {
    const ControlPoint& below = *std::prev(above);
    const Shares shares = Shares::ofData(below.scalar, above->scalar, scalar);
    result.color = shares.mix(below.color, above->color);
    result.opacity = shares.mix(below.opacity, above->opacity);
  }
  result.scalar = scalar;
  return result;
}

}  // namespace havs
