#include "light/line_frame.h"

namespace havs::detail {

/// Where both products round to `product`: the sign of what they lost, else of the edge as the ray moves aside.
LineSide closeSide(const LinePoint& a, const LinePoint& b, double product) {
  const double value = std::fma(a.x, b.y, -product) - std::fma(a.y, b.x, -product);
  const auto signOf = [](double x) { return x > 0 ? 1 : x < 0 ? -1 : 0; };
  int sign = signOf(value);
  if (sign == 0) sign = signOf(a.y - b.y);  // as e grows
  if (sign == 0) sign = signOf(b.x - a.x);  // as e^2 grows
  return {value, sign};
}

}  // namespace havs::detail
