#include "light/extinction_integral.h"

#include <gtest/gtest.h>

#include "unit/gauss_kronrod.h"
#include "unit/light/light_scene.h"

namespace havs::test {
namespace {

ExtinctionCurve steps() {
  return curveOf({{0, 1}, {0.2, 0}, {0.25, 6}, {0.25, 2}, {0.31, 2}, {0.5, 1e-9}, {0.75, 0}, {0.75, 4e6}, {1, 0.5}});
}

/// From knot to knot, by trapezia.
long double integral(const ExtinctionCurve& curve, double a, double b) {
  long double sum = 0;
  for (std::size_t i = 0; i + 1 < curve.knots.size(); ++i) {
    const auto &k = curve.knots[i], &l = curve.knots[i + 1];
    const long double from = std::max(a, k.s), to = std::min(b, l.s), width = static_cast<long double>(l.s) - k.s;
    if (!(from < to)) continue;
    const auto kappa = [&](long double s) { return ((l.s - s) * k.kappa + (s - k.s) * l.kappa) / width; };
    sum += (kappa(from) + kappa(to)) / 2 * (to - from);
  }
  return sum;
}

TEST(ExtinctionIntegral, MeansAreGoodToTheLastDigits) {
  const ExtinctionCurve curve = steps();
  const ExtinctionIntegral extinction(curve);
  const std::vector<double> places{0,     1e-300,       1e-9, 0.1,  0.2 - 1e-12, 0.2, 0.2 + 1e-15,
                                   0.249, 0.25 - 1e-16, 0.25, 0.27, 0.31,        0.4, 0.5,
                                   0.6,   0.75 - 1e-16, 0.75, 0.8,  1 - 1e-16,   1};
  for (const double a : places)
    for (const double b : places) {
      if (!(a < b)) continue;
      const double mean = static_cast<double>(integral(curve, a, b) / (static_cast<long double>(b) - a));
      // A few roundings of sums of positive numbers. Kappa itself, near a knot where it is 0, is known to its place's
      // last digit times the slope (6 / 0.05).
      EXPECT_NEAR(extinction.mean(a, b), mean, 1e-15 * mean + 120 * 0x1p-54) << a << ' ' << b;
      EXPECT_EQ(extinction.mean(a, b), extinction.mean(b, a));
    }
}

TEST(ExtinctionIntegral, OneScalarIsTheCurveItself) {
  const ExtinctionCurve curve = steps();
  const ExtinctionIntegral extinction(curve);
  for (const double s : {0.0, 0.1, 0.2, 0.25, 0.3, 0.31, 0.6, 0.75, 0.9, 1.0})
    EXPECT_NEAR(extinction.mean(s, s), curve.at(s).kappa, 1e-15 * curve.at(s).kappa);
}

/// Three shares that add up to 1 give it of three corners at 1. What was read behind the last piece then was anything.
TEST(ExtinctionIntegral, ScalarsMayLieBeyondTheEndsByTheirRounding) {
  const ExtinctionCurve curve = steps();
  const ExtinctionIntegral extinction(curve);
  const double above = 1 + 0x1p-52, below = -0x1p-52;
  for (const double s : {0.8, 1.0, above}) {
    EXPECT_NEAR(extinction.mean(s, above), extinction.mean(s, 1.0), 4e6 * 0x1p-50);  // the slope is 1.6e7
    EXPECT_NEAR(extinction.secondMoment(0, 1, s, above), extinction.secondMoment(0, 1, s, 1.0), 4e6 * 0x1p-50);
  }
  EXPECT_NEAR(extinction.mean(below, 0.1), extinction.mean(0.0, 0.1), 1e-14);
}

TEST(ExtinctionIntegral, CurvesOfManyKnots) {
  ExtinctionCurve curve;
  for (int i = 0; i <= 3000; ++i) curve.knots.push_back({i / 3000.0, {}, 1 + std::sin(i * 0.01)});
  const ExtinctionIntegral extinction(curve);
  for (const auto& [a, b] : {std::array{0.0, 1.0}, std::array{0.1234, 0.1235}, std::array{0.4, 0.9}}) {
    const double mean = static_cast<double>(integral(curve, a, b) / (static_cast<long double>(b) - a));
    EXPECT_NEAR(extinction.mean(a, b), mean, 1e-15 * mean);
  }
}

TEST(ExtinctionIntegral, SecondMoment) {
  const ExtinctionCurve curve = curveOf({{0, 1}, {0.2, 0}, {0.25, 6}, {0.25, 2}, {0.31, 2}, {1, 5}});
  const ExtinctionIntegral extinction(curve);
  for (const auto& [s0, s1] :
       {std::array{0.0, 1.0}, std::array{0.9, 0.1}, std::array{0.26, 0.27}, std::array{0.5, 0.5}}) {
    const double r0 = 0.3, r1 = 1.1;
    long double expected = 0;
    std::vector<long double> cuts{r0, r1};
    for (const auto& knot : curve.knots)
      if (s0 != s1) cuts.push_back(std::clamp<long double>(r0 + (r1 - r0) * (knot.s - s0) / (s1 - s0), r0, r1));
    std::sort(cuts.begin(), cuts.end());
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i)
      if (cuts[i] < cuts[i + 1])
        expected += integrate(
            [&, from = s0, to = s1](long double r) {
              return r * r * curve.at(static_cast<double>(from + (to - from) * (r - r0) / (r1 - r0))).kappa;
            },
            cuts[i], cuts[i + 1], 12);
    EXPECT_NEAR(extinction.secondMoment(r0, r1, s0, s1), static_cast<double>(expected), 1e-14);
    EXPECT_EQ(extinction.secondMoment(r1, r0, s1, s0), -extinction.secondMoment(r0, r1, s0, s1));
  }
}

TEST(ExtinctionIntegral, OpaqueIntervalsAreClosed) {
  ExtinctionCurve curve = constantKappa(1);
  curve.opaque = {{0.2, 0.2}, {0.5, 0.6}};
  const ExtinctionIntegral extinction(curve);
  EXPECT_TRUE(extinction.isOpaque(0.2, 0.1));
  EXPECT_TRUE(extinction.isOpaque(0.6, 0.9));
  EXPECT_TRUE(extinction.isOpaque(0.55, 0.55));
  EXPECT_FALSE(extinction.isOpaque(0.21, 0.49));
  EXPECT_FALSE(extinction.isOpaque(0.7, 0.61));
}

}  // namespace
}  // namespace havs::test
