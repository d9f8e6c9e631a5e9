#pragma once
#include <array>
#include <cmath>

namespace havs {

/// Where x lies between a < b, as the shares of both ends: each to the last digit, also of the small one.
struct Shares {
  double lower;
  double upper;
  Shares(double a, double b, double x) {
    const double part = std::isfinite(b - a) ? 1.0 : 0.5;  // data may span more than the largest double
    const double span = part * b - part * a;
    lower = (part * b - part * x) / span;
    upper = (part * x - part * a) / span;
  }
  double mix(double a, double b) const { return lower * a + upper * b; }
  std::array<double, 3> mix(const std::array<double, 3>& a, const std::array<double, 3>& b) const {
    return {mix(a[0], b[0]), mix(a[1], b[1]), mix(a[2], b[2])};
  }
};

}  // namespace havs
