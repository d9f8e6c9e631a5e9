#pragma once
// What a segment shows, from the control points by the definition: quadrature in long double, of its own and not of the
// code that draws. No point is resampled and nothing is tabulated.
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "transfer/resolution.h"
#include "unit/gauss_kronrod.h"

namespace havs::test {

/// (r, g, b premultiplied, opacity).
using SegmentRgba = std::array<double, 4>;

inline double distance(const SegmentRgba& a, const SegmentRgba& b) {
  double most = 0;
  for (std::size_t c = 0; c < 4; ++c) most = std::max(most, std::abs(a[c] - b[c]));
  return most;
}

/// Control points {scalar, r, g, b, opacity}, ascending, as transferOf() takes them. Steps lie kStepMargin lower
/// (transfer/resolution.h).
class SegmentTruth {
 public:
  using Points = std::vector<std::array<double, 5>>;
  SegmentTruth(Points points, bool perUnit, double unitLength = 1)
      : points_(std::move(points)), perUnit_(perUnit), unitLength_(unitLength) {
    for (std::size_t i = 1; i < points_.size(); ++i)
      if (points_[i][0] == points_[i - 1][0]) points_[i][0] = points_[i - 1][0] *= 1 - kStepMargin;
  }

  /// The segment on which the scalar goes from `from` to `to` in `length`, in the unit of the unit length.
  SegmentRgba along(double from, double to, double length) const {
    std::vector<double> cuts{0, 1};
    for (const auto& p : points_) {
      const double t = (p[0] - from) / (to - from);
      if (t > 0 && t < 1) cuts.push_back(t);
    }
    std::sort(cuts.begin(), cuts.end());
    std::array<long double, 4> sum{};
    long double depth = 0;
    for (std::size_t i = 1; i < cuts.size(); ++i) {
      if (!(cuts[i - 1] < cuts[i])) continue;
      const Stretch stretch = stretchOf(from, to, cuts[i - 1], cuts[i], length);
      if (isSurface(stretch.at(0))) return withSurface(sum, stretch.at(0), depth);
      for (std::size_t c = 0; c < 3; ++c) sum[c] += std::exp(-depth) * lightOf(stretch, c);
      depth += depthOf(stretch, 1);
      if (isSurface(stretch.at(1))) return withSurface(sum, stretch.at(1), depth);
    }
    sum[3] = -std::expm1(-depth);
    return rounded(sum);
  }

 private:
  using Sample = std::array<long double, 5>;
  /// Up to what rounding the place of a control point takes from an opacity of 1.
  bool isSurface(const Sample& sample) const { return perUnit_ && sample[4] >= 1 - 1e-12L; }
  /// A part of the way on which colour and opacity are linear.
  struct Stretch {
    Sample front, back;
    long double length;
    Sample at(long double t) const {
      Sample s;
      for (std::size_t i = 0; i < 5; ++i) s[i] = (1 - t) * front[i] + t * back[i];
      return s;
    }
  };

  Stretch stretchOf(double from, double to, double begin, double end, double length) const {
    const auto scalarAt = [&](long double t) { return (1 - t) * from + t * to; };
    const long double middle = scalarAt((static_cast<long double>(begin) + end) / 2);
    // At a step the upper side holds.
    const auto above = std::find_if(points_.begin(), points_.end(), [&](const auto& p) { return p[0] > middle; });
    const auto &high = above == points_.end() ? points_.back() : *above,
               &low = above == points_.begin() ? points_.front() : *std::prev(above);
    const auto sampleAt = [&](long double s) {
      const long double share = high[0] > low[0] ? std::clamp((s - low[0]) / (high[0] - low[0]), 0.0L, 1.0L) : 0.0L;
      Sample sample;
      for (std::size_t i = 0; i < 5; ++i) sample[i] = (1 - share) * low[i] + share * high[i];
      return sample;
    };
    return {sampleAt(scalarAt(begin)), sampleAt(scalarAt(end)), (static_cast<long double>(end) - begin) * length};
  }

  long double kappaOf(const Stretch& stretch, long double t) const {
    const long double opacity = stretch.at(t)[4];
    return stretch.length / unitLength_ * (perUnit_ ? -std::log1p(-opacity) : opacity);
  }
  /// Optical depth from the front to t. The integral of -ln(1 - o) over o is o + (1 - o) ln(1 - o).
  long double depthOf(const Stretch& stretch, long double t) const {
    const long double a = stretch.front[4], b = stretch.at(t)[4];
    if (!perUnit_ || std::abs(b - a) < 1e-6L) return t * (kappaOf(stretch, 0) + kappaOf(stretch, t)) / 2;
    const auto integral = [](long double o) { return o < 1 ? o + (1 - o) * std::log1p(-o) : o; };
    return t * stretch.length / unitLength_ * (integral(b) - integral(a)) / (b - a);
  }

  /// Of channel c. What is deep shows at its front only: so the way is halved towards it until it is shallow.
  long double lightOf(const Stretch& stretch, std::size_t c) const {
    constexpr int kHalvings = 5;  // of 15 nodes each
    const auto light = [&](long double t) {
      return stretch.at(t)[c + 1] * kappaOf(stretch, t) * std::exp(-depthOf(stretch, t));
    };
    long double sum = 0, end = 1;
    for (; depthOf(stretch, end) > 1; end /= 2) sum += integrate(light, end / 2, end, kHalvings);
    return sum + integrate(light, 0, end, kHalvings);
  }

  static SegmentRgba withSurface(std::array<long double, 4> sum, const Sample& surface, long double depth) {
    for (std::size_t c = 0; c < 3; ++c) sum[c] += std::exp(-depth) * surface[c + 1];
    sum[3] = 1;
    return rounded(sum);
  }
  static SegmentRgba rounded(const std::array<long double, 4>& sum) {
    return {static_cast<double>(sum[0]), static_cast<double>(sum[1]), static_cast<double>(sum[2]),
            static_cast<double>(sum[3])};
  }

  Points points_;
  bool perUnit_;
  double unitLength_;
};

}  // namespace havs::test
