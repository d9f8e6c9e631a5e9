#pragma once
#include <array>

namespace havs {

/// Where x lies between a < b, as the shares of both ends: each to the last digit, also of the small one.
struct Shares {
  double lower;
  double upper;
  Shares(double a, double b, double x) : lower((b - x) / (b - a)), upper((x - a) / (b - a)) {}
  double mix(double a, double b) const { return lower * a + upper * b; }
  std::array<double, 3> mix(const std::array<double, 3>& a, const std::array<double, 3>& b) const {
    return {mix(a[0], b[0]), mix(a[1], b[1]), mix(a[2], b[2])};
  }
};

}  // namespace havs
