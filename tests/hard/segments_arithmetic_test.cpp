// The integral of one segment, as the devices compute it, in double and in float, against the definition.
#include "hard/hard_case.h"
#include "hard/segment_truth.h"
#include "transfer/packed_curve.h"
#include "transfer/preintegration.h"

namespace havs::test {
namespace {

using Segments = HardTest;
using Points = SegmentTruth::Points;

ExtinctionCurve curveOf(const Points& points, bool perUnit, double unitLength = 1) {
  TransferFunction function;
  for (const auto& [scalar, r, g, b, opacity] : points) function.points.push_back({scalar, {r, g, b}, opacity});
  function.meaning = perUnit ? OpacityMeaning::perUnit : OpacityMeaning::extinction;
  function.unitLength = unitLength;
  return makeCurve(function, {});
}

/// `exact` of core/exact.glsl over the packed curve, in the numbers of a lane.
template <class Lane>
class CoreExact {
 public:
  using Number = typename Lane::Real;
  explicit CoreExact(const ExtinctionCurve& curve) : packed_(packCurve<Number>(curve)), fetch_(packed_) {}
  SegmentRgba operator()(double from, double to, double length) const {
    const auto c = Arithmetic<Lane>::exactSegment(fetch_, static_cast<Number>(from), static_cast<Number>(to),
                                                  static_cast<Number>(length));
    return {c.r, c.g, c.b, c.a};
  }

 private:
  PackedCurve<Number> packed_;
  CurveFetch<Lane> fetch_;
};

SegmentRgba integrated(const ExtinctionCurve& curve, double from, double to, double length) {
  const SegmentColor c = integrateSegment(curve, from, to, length);
  return {c.color[0], c.color[1], c.color[2], c.alpha};
}

/// Largest error of a channel as a part of itself; of channels of exactly 0, as it is.
double relativeDistance(const SegmentRgba& got, const SegmentRgba& expected) {
  double most = 0;
  for (std::size_t c = 0; c < 4; ++c) {
    const double difference = std::abs(got[c] - expected[c]);
    most = std::max(most, expected[c] > 0 ? difference / expected[c] : difference);
  }
  return most;
}

/// A steep ramp, a step and a gentle ramp.
const Points kRampsAndStep{
    {0, 1, 0.2, 0, 0}, {0.3, 0, 0.9, 1, 8}, {0.5, 1, 1, 0.3, 2}, {0.5, 0.1, 0.4, 1, 12}, {1, 0.9, 0.3, 0.1, 0.5}};

// 12 and 22 nodes, or a series, give the weights to 1e-14 and 1e-7 (docs/02-method.md); a segment has at most five
// pieces, and float five roundings of 6e-8 a piece.
constexpr double kDouble = 1e-13, kFloat = 1e-6;

TEST_F(Segments, EndsThatDifferByLittleAgainstQuadrature) {
  tell({"Segments",
        "(K(back) - K(front)) / (back - front), as in the seed's 1D table, has no digit left in float from differences "
        "of 1e-7 on",
        "a segment is integrated in the piece that both ends lie in, as a function of its optical depths: equal ends "
        "are the limit, without a case of their own"});
  const ExtinctionCurve curve = curveOf(kRampsAndStep, false);
  const SegmentTruth truth(kRampsAndStep, false);
  const CoreExact<DoubleLane> inDouble(curve);
  const CoreExact<FloatLane> inFloat(curve);
  for (int exponent = -12; exponent <= -1; ++exponent)
    for (const double from : {0.0, 1e-6, 0.299999, 0.3, 0.37, 0.5, 0.8})
      for (const double sign : {-1.0, 1.0})
        for (const double length : {1e-7, 0.01, 1.0, 5.0}) {
          const double to = std::clamp(from + sign * std::pow(10.0, exponent), 0.0, 1.0);
          const SegmentRgba expected = truth.along(from, to, length);
          expectAtMost("tables' integral", distance(integrated(curve, from, to, length), expected), kDouble);
          expectAtMost("`exact` in double", distance(inDouble(from, to, length), expected), kDouble);
          const float f = static_cast<float>(from), b = static_cast<float>(to);
          expectAtMost("`exact` in float", distance(inFloat(f, b, length), truth.along(f, b, length)), kFloat);
        }
}

TEST_F(Segments, LengthsFromNothingToAMillionUnitLengths) {
  tell(
      {"Segments",
       "1 - exp(-x) of a thin segment cancels: nothing is left of a depth of 1e-8 in float; exp of a deep one's square "
       "overflows",
       "both weights are sums of positive terms with the relative accuracy of their terms; a deep piece is integrated "
       "as far as light comes"});
  const ExtinctionCurve curve = curveOf(kRampsAndStep, false);
  const SegmentTruth truth(kRampsAndStep, false);
  const CoreExact<DoubleLane> inDouble(curve);
  const CoreExact<FloatLane> inFloat(curve);
  for (const double length : {0.0, 1e-30, 1e-20, 1e-12, 1e-8, 1e-4, 0.1, 1.0, 30.0, 1e3, 1e6})
    for (const auto& [from, to] : {std::pair{0.37, 0.37}, {0.25, 0.75}, {0.875, 0.125}, {0.3125, 0.34375}}) {
      const SegmentRgba expected = truth.along(from, to, length);
      expectAtMost("tables' integral, relative", relativeDistance(integrated(curve, from, to, length), expected),
                   kDouble);
      expectAtMost("`exact` in double, relative", relativeDistance(inDouble(from, to, length), expected), kDouble);
      const float f = static_cast<float>(from), b = static_cast<float>(to);
      expectAtMost("`exact` in float, relative", relativeDistance(inFloat(f, b, length), truth.along(f, b, length)),
                   kFloat);
    }
}

TEST_F(Segments, OpacitiesFromNothingToAllButOne) {
  tell({"Segments", "-ln(1 - opacity) is infinite at 1, and ln(1 - 1e-8) is 0 in float",
        "extinction is made in double by log1p, and opacity counts as 1 - 2^-24 at most where it is no surface"});
  constexpr double kAlmostOne = 1 - 0x1p-24;
  for (const double opacity : {0.0, 1e-30, 1e-8, 1e-3, 0.5, 0.999, 1 - 1e-6, kAlmostOne}) {
    const ExtinctionCurve curve = curveOf({{0, 1, 0.5, 0, opacity}, {1, 1, 0.5, 0, opacity}}, true, 2.0);
    const CoreExact<DoubleLane> inDouble(curve);
    const CoreExact<FloatLane> inFloat(curve);
    for (const double length : {0.0, 1e-6, 0.02, 2.0, 40.0}) {  // in float 1e-30 of 1e-6 is still a normal number
      const auto alpha = static_cast<double>(-std::expm1(length / 2 * std::log1p(-static_cast<long double>(opacity))));
      const SegmentRgba expected{alpha, alpha / 2, 0, alpha};
      expectAtMost("in double, relative", relativeDistance(inDouble(0.2, 0.7, length), expected), kDouble);
      expectAtMost("in float, relative", relativeDistance(inFloat(0.25, 0.75, length), expected), kFloat);
    }
  }
}

}  // namespace
}  // namespace havs::test
