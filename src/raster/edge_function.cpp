#include "raster/edge_function.h"

#include <cmath>

#include "raster/exact_sum.h"

namespace havs {
namespace {

int signOf(double value) { return value > 0 ? 1 : value < 0 ? -1 : 0; }

/// The sign of a b - c d.
int signOfDifference(double a, double b, double c, double d) {
  ExactSum<4> sum;
  sum.addProduct(a, b);
  sum.addProduct(-c, d);
  return signOf(sum.value());
}

}  // namespace

double edgeLimit(const ScreenPoint& a, const ScreenPoint& b, int width, int height) {
  // With u = 2^-53, ax - x aw is off by at most 2 u (|ax| + width |aw|), and so on: the difference of products by at
  // most 8 u of the product of these sums, counting their own two roundings, to first order.
  constexpr double kRounding = 9 * 0x1p-53;
  constexpr double kQuality = 0x1p20;
  const double ax = std::abs(a.x) + width * std::abs(a.w), ay = std::abs(a.y) + height * std::abs(a.w);
  const double bx = std::abs(b.x) + width * std::abs(b.w), by = std::abs(b.y) + height * std::abs(b.w);
  return kQuality * kRounding * (ax * by + ay * bx);
}

EdgeSide exactEdgeSide(const ScreenPoint& a, const ScreenPoint& b, double x, double y) {
  // Multiplied out; the terms with x y cancel.
  ExactSum<20> sum;
  sum.addProduct(a.x, b.y);
  sum.addProduct(-a.y, b.x);
  sum.addProduct(a.y, b.w, x);
  sum.addProduct(-a.w, b.y, x);
  sum.addProduct(a.w, b.x, y);
  sum.addProduct(-a.x, b.w, y);
  EdgeSide side{sum.value(), 0};
  side.sign = signOf(side.value);
  if (side.sign == 0) side.sign = signOfDifference(a.y, b.w, a.w, b.y);  // as x grows
  if (side.sign == 0) side.sign = signOfDifference(a.w, b.x, a.x, b.w);  // as y grows
  return side;
}

}  // namespace havs
