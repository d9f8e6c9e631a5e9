// The lookups without tables of colours, by the shaders' own arithmetic over a packed curve, against integrateSegment.
#include "transfer/packed_curve.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "transfer/pieces.h"
#include "transfer/preintegration.h"

namespace havs {
namespace {

ExtinctionCurve presetCurve(const std::string& name) {
  return withoutOpaque(makeCurve(loadTransferFunction(name), {}));
}

/// Steps everywhere, at both ends too, and knots that lie a few 1e-12 from one another.
ExtinctionCurve hardCurve() {
  ExtinctionCurve curve;
  curve.maximumKappa = 40;
  curve.knots = {{0, {1, 0, 0}, 5},         {0, {0, 1, 0}, 1},           {0.25, {0, 1, 0}, 3},
                 {0.25, {1, 1, 0}, 0},      {0.5 - 1e-12, {1, 0, 1}, 2}, {0.5 + 2e-12, {0, 0, 1}, 9},
                 {0.7, {1, 0.2, 0.3}, 0},   {0.75, {1, 0.2, 0.3}, 0},    {0.7500001, {0, 1, 1}, 40},
                 {0.7500002, {1, 1, 1}, 0}, {1, {0, 0, 1}, 4},           {1, {1, 1, 1}, 2}};
  return curve;
}

struct Case {
  float front, back, length;
};

/// Segments of all lengths, short and long spans, scalars on knots and next to them, equal ends.
std::vector<Case> cases(const ExtinctionCurve& curve) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<float> unit(0, 1);
  std::vector<Case> list;
  for (int i = 0; i < 6000; ++i) {
    const float length = std::pow(10.0F, -4 + 4.5F * unit(random));
    float front = unit(random), back = unit(random);
    if (i % 3 == 0) back = front + (unit(random) - 0.5F) * 0.02F;
    if (i % 7 == 0) front = static_cast<float>(curve.knots[random() % curve.knots.size()].s);
    if (i % 11 == 0) back = static_cast<float>(curve.knots[random() % curve.knots.size()].s);
    if (i % 13 == 0) back = front;
    if (i % 17 == 0) back = std::nextafter(front, 2.0F);
    list.push_back({std::clamp(front, 0.0F, 1.0F), std::clamp(back, 0.0F, 1.0F), length});
  }
  return list;
}

template <class C>
double distance(const C& got, const SegmentColor& exact) {
  return std::max({std::abs(got.r - exact.color[0]), std::abs(got.g - exact.color[1]), std::abs(got.b - exact.color[2]),
                   std::abs(got.a - exact.alpha)});
}

std::vector<std::pair<std::string, ExtinctionCurve>> curves() {
  std::vector<std::pair<std::string, ExtinctionCurve>> list{{"hard", hardCurve()}};
  for (const TransferPreset& preset : transferPresets()) list.emplace_back(preset.name, presetCurve(preset.name));
  return list;
}

template <class Lane>
double worstOfExact(const ExtinctionCurve& curve) {
  using Real = typename Lane::Real;
  const PackedCurve<Real> packed = packCurve<Real>(curve);
  const CurveFetch<Lane> fetch(packed);
  double worst = 0;
  for (const Case& c : cases(curve)) {
    const double d = distance(Arithmetic<Lane>::exactSegment(fetch, Real(c.front), Real(c.back), Real(c.length)),
                              integrateSegment(curve, c.front, c.back, c.length));
    if (d > worst) worst = d;
  }
  return worst;
}

TEST(ExactLookup, IsTheSegmentsIntegral) {
  for (const auto& [name, curve] : curves()) {
    const double inDouble = worstOfExact<DoubleLane>(curve), inFloat = worstOfExact<FloatLane>(curve);
    RecordProperty(name, std::to_string(inDouble * 1e15) + "e-15, float " + std::to_string(inFloat * 1e7) + "e-7");
    EXPECT_LE(inDouble, 1e-13) << name;
    EXPECT_LE(inFloat, 1e-6) << name;
  }
}

// White stays white, no colour exceeds its opacity, no opacity 1, by more than the last digits.
TEST(ExactLookup, StaysWithinItsBounds) {
  using A = Arithmetic<FloatLane>;
  for (const auto& [name, curve] : curves()) {
    ExtinctionCurve bright = curve;
    for (auto& knot : bright.knots) knot.color = {1, knot.color[1], 0};
    const PackedCurve<float> packed = packCurve<float>(bright);
    const CurveFetch<FloatLane> fetch(packed);
    for (const Case& c : cases(bright)) {
      const A::Rgba got = A::exactSegment(fetch, c.front, c.back, c.length);
      ASSERT_TRUE(got.a >= 0 && got.a <= 1 + 0x1p-22F);
      ASSERT_NEAR(got.r, got.a, 0x1p-22);
      ASSERT_LE(got.g, got.a + 0x1p-22F);
      ASSERT_EQ(got.b, 0);
    }
  }
}

TEST(ExactLookup, EndsForSegmentsBeyondAllBounds) {
  using A = Arithmetic<FloatLane>;
  const PackedCurve<float> packed = packCurve<float>(presetCurve("three-peaks"));
  const CurveFetch<FloatLane> fetch(packed);
  for (float length : {1e10F, 3e38F, std::numeric_limits<float>::infinity()})
    EXPECT_GT(A::exactSegment(fetch, 0.2F, 0.9F, length).a, 0.999F) << length;
  EXPECT_EQ(A::exactSegment(fetch, 0.2F, 0.9F, 0).a, 0);
}

// The mean extinction by the integral functions, in float, relative to what it is: no digit is lost where the segment
// is short. Of the scalars' own rounding nothing is left, as both sides get the same floats.
TEST(IntegralLookup, MeanExtinctionOfShortAndLongSegments) {
  using F = Arithmetic<FloatLane>;
  for (const auto& [name, curve] : curves()) {
    const PackedCurve<float> packed = packCurve<float>(curve);
    const CurveFetch<FloatLane> fetch(packed);
    double worst = 0;
    for (const Case& c : cases(curve)) {
      double depth = 0;
      const double whole = std::abs(static_cast<double>(c.back) - c.front);
      visitPieces(curve, c.front, c.back,
                  [&](const Rgba& a, const Rgba& b, double extent) { depth += extent / whole * 0.5 * (a.a + b.a); });
      if (whole == 0) depth = curve.at(c.front).kappa;
      const double got = F::meanExtinction(fetch, F::coverageOf(fetch, c.front, c.back));
      // Shares are good to 1e-7 of a piece: what is small at one end of a steep piece is so against its other end.
      worst = std::max(worst, std::abs(got - depth) / (depth + 0.01 * curve.maximumKappa));
    }
    RecordProperty(name, std::to_string(worst * 1e7) + "e-7");
    EXPECT_LE(worst, 2e-6) << name;
  }
}

// Against the definition, in double: K and the integral of colour times extinction, piece by piece.
TEST(IntegralLookup, IsTheIntegralOfTheLight) {
  for (const auto& [name, curve] : curves()) {
    const PackedCurve<double> packed = packCurve<double>(curve);
    const CurveFetch<DoubleLane> fetch(packed);
    const PackedCurve<float> packedFloat = packCurve<float>(curve);
    const CurveFetch<FloatLane> fetchFloat(packedFloat);
    double worst = 0, worstFloat = 0;
    for (const Case& c : cases(curve)) {
      if (c.front == c.back) continue;
      SegmentColor exact;
      const double whole = std::abs(static_cast<double>(c.back) - c.front);
      double depth = 0;
      visitPieces(curve, c.front, c.back, [&](const Rgba& a, const Rgba& b, double extent) {
        const double length = extent / whole * c.length, wa = (2 * a.a + b.a) / 6, wb = (a.a + 2 * b.a) / 6;
        depth += length * (a.a + b.a) / 2;
        exact.color[0] += length * (wa * a.r + wb * b.r);
        exact.color[1] += length * (wa * a.g + wb * b.g);
        exact.color[2] += length * (wa * a.b + wb * b.b);
      });
      exact.alpha = -std::expm1(-depth);
      for (double& channel : exact.color) channel = std::min(channel, exact.alpha);
      worst = std::max(worst, distance(DoubleArithmetic::integralSegment(fetch, c.front, c.back, c.length), exact));
      worstFloat = std::max(
          worstFloat, distance(Arithmetic<FloatLane>::integralSegment(fetchFloat, c.front, c.back, c.length), exact));
    }
    RecordProperty(name, std::to_string(worst * 1e15) + "e-15, float " + std::to_string(worstFloat * 1e7) + "e-7");
    EXPECT_LE(worst, 1e-12) << name;
    EXPECT_LE(worstFloat, 2e-6) << name;
  }
}

TEST(PackedCurve, ValuesAreThoseOfTheCurve) {
  for (const auto& [name, curve] : curves()) {
    const PackedCurve<double> packed = packCurve<double>(curve);
    const CurveFetch<DoubleLane> fetch(packed);
    for (const Case& c : cases(curve)) {
      const double s = c.front;
      const auto expected = curve.at(s);
      const Rgba got = DoubleArithmetic::curveAt(fetch, s);
      ASSERT_NEAR(got.a, expected.kappa, 1e-12 * curve.maximumKappa + 1e-12) << name << " " << s;
      ASSERT_NEAR(got.g, expected.color[1], 1e-12) << name << " " << s;
    }
  }
}

// 65,536 entries with a kink at each: the most that a file holds. The guide leads close enough.
TEST(PackedCurve, HoldsTheLargestFile) {
  ExtinctionCurve curve;
  constexpr int kLast = 65535;
  for (int i = 0; i <= kLast; ++i)
    curve.knots.push_back({static_cast<double>(i) / kLast, {1, 0.5 * (i % 2), 0}, static_cast<double>(i % 3)});
  const PackedCurve<float> packed = packCurve<float>(curve);
  const CurveFetch<FloatLane> fetch(packed);
  EXPECT_EQ(packed.pieces.size(), 3U * kLast);
  for (float front : {0.0F, 0.3F, 0.77777F, 1.0F})
    for (float span : {0.0F, 1e-6F, 1e-3F, -2e-3F}) {
      const float back = std::clamp(front + span, 0.0F, 1.0F);
      EXPECT_LE(distance(Arithmetic<FloatLane>::exactSegment(fetch, front, back, 0.5F),
                         integrateSegment(curve, front, back, 0.5)),
                1e-6)
          << front << " " << span;
    }
}

}  // namespace
}  // namespace havs
