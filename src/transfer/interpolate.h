#pragma once
#include <array>
#include <cmath>

namespace havs {

/// Where x lies between a < b, as the shares of both ends: each to the last digit, also of the small one.
struct Shares {
  double lower;
  double upper;
  Shares(double a, double b, double x) : lower((b - x) / (b - a)), upper((x - a) / (b - a)) {}
  /// The same of ends that may lie farther apart than the largest double, as data's may.
  static Shares ofData(double a, double b, double x) {
    const double scale = std::isfinite(b - a) ? 1.0 : 0.5;
    return {scale * a, scale * b, scale * x};
  }
  double mix(double a, double b) const { return lower * a + upper * b; }
  std::array<double, 3> mix(const std::array<double, 3>& a, const std::array<double, 3>& b) const {
    return {mix(a[0], b[0]), mix(a[1], b[1]), mix(a[2], b[2])};
  }
};

}  // namespace havs
