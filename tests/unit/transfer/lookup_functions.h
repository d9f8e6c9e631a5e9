#pragma once
// The lookups as functions of a segment, in double, by the shaders' own arithmetic over the very tables: how far they
// are from integrateSegment.
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <memory>
#include <vector>

#include "transfer/mean_tables.h"
#include "transfer/packed_curve.h"
#include "transfer/pieces.h"
#include "transfer/preintegration.h"

namespace havs::test {

/// (front scalar, back scalar, length) -> premultiplied colour and opacity.
using LookupFunction = std::function<Rgba(double front, double back, double length)>;

/// A packed curve and its fetch functions, kept together.
class PackedFetch {
 public:
  explicit PackedFetch(const ExtinctionCurve& curve)
      : packed_(std::make_shared<PackedCurve<double>>(packCurve<double>(curve))), fetch_(*packed_) {}
  const CurveFetch<DoubleLane>& operator*() const { return fetch_; }

 private:
  std::shared_ptr<PackedCurve<double>> packed_;
  CurveFetch<DoubleLane> fetch_;
};

/// Multilinear interpolation in a table of four floats an entry, `sizes` along its axes, the first axis fastest.
template <std::size_t axes>
Rgba interpolated(const std::vector<float>& rgba, const std::array<int, axes>& sizes,
                  const std::array<double, axes>& unit) {
  std::array<std::size_t, axes> low{};
  std::array<double, axes> share{};
  for (std::size_t i = 0; i < axes; ++i) {
    const double at = unit[i] * (sizes[i] - 1);
    low[i] = static_cast<std::size_t>(std::min(static_cast<int>(at), sizes[i] - 2));
    share[i] = at - static_cast<double>(low[i]);
  }
  std::array<double, 4> sum{};
  for (std::size_t corner = 0; corner < (std::size_t{1} << axes); ++corner) {
    double weight = 1;
    std::size_t index = 0;
    for (std::size_t i = axes; i-- > 0;) {
      const std::size_t up = corner >> i & 1;
      weight *= up ? share[i] : 1 - share[i];
      index = index * static_cast<std::size_t>(sizes[i]) + low[i] + up;
    }
    if (weight == 0) continue;
    for (std::size_t c = 0; c < 4; ++c) sum[c] += weight * static_cast<double>(rgba[4 * index + c]);
  }
  return {sum[0], sum[1], sum[2], sum[3]};
}

inline Rgba interpolated(const Table3d& table, double front, double back, double length) {
  return interpolated<3>(table.rgba, {table.size, table.size, table.lengths},
                         {front, back, length / table.maximumLength});
}

inline LookupFunction postLookup(const ExtinctionCurve& curve) {
  return [fetch = PackedFetch(curve)](double f, double b, double length) {
    using A = DoubleArithmetic;
    return A::trapezoidSegment(A::curveAt(*fetch, f), A::curveAt(*fetch, b), length);
  };
}

inline LookupFunction riemannLookup(const ExtinctionCurve& curve, int n) {
  return [fetch = PackedFetch(curve), n](double f, double b, double length) {
    return DoubleArithmetic::riemannSegment(*fetch, f, b, length, n);
  };
}

inline LookupFunction riemannLinearLookup(const ExtinctionCurve& curve, int n) {
  return [fetch = PackedFetch(curve), n](double f, double b, double length) {
    return DoubleArithmetic::riemannLinearSegment(*fetch, f, b, length, n);
  };
}

inline LookupFunction integralLookup(const ExtinctionCurve& curve) {
  return [fetch = PackedFetch(curve)](double f, double b, double length) {
    return DoubleArithmetic::integralSegment(*fetch, f, b, length);
  };
}

inline LookupFunction table2dLookup(const ExtinctionCurve& curve, int size, double tableLength) {
  return [table = buildMeanTable2d(curve, size, tableLength)](double f, double b, double length) {
    const Rgba mean = interpolated<2>(table.rgba, {table.size, table.size}, {f, b});
    return DoubleArithmetic::layerOfDepth(mean, mean.a * length);
  };
}

inline LookupFunction table3dLookup(const ExtinctionCurve& curve, int size, double maximumLength) {
  return [table = buildTable3d(curve, size, maximumLength)](double f, double b, double length) {
    return interpolated(table, f, b, length);
  };
}

inline LookupFunction normalisedLookup(const ExtinctionCurve& curve, int size, double maximumLength) {
  return [table = buildMeanColors(curve, size, maximumLength), fetch = PackedFetch(curve)](double f, double b,
                                                                                           double length) {
    using A = DoubleArithmetic;
    const Rgba mean = interpolated(table, f, b, length);
    return A::layerOfDepth(mean, length * A::meanExtinction(*fetch, A::coverageOf(*fetch, f, b)));
  };
}

inline double distance(const Rgba& got, const Rgba& exact) {
  return std::max(
      {std::abs(got.r - exact.r), std::abs(got.g - exact.g), std::abs(got.b - exact.b), std::abs(got.a - exact.a)});
}

inline Rgba exactly(const ExtinctionCurve& curve, double front, double back, double length) {
  const SegmentColor c = integrateSegment(curve, front, back, length);
  return {c.color[0], c.color[1], c.color[2], c.alpha};
}

}  // namespace havs::test
