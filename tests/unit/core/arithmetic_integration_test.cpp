// The weights of a linear piece (shaders/core/integration.glsl) against adaptive quadrature over the whole domain:
// optical depths 0 and 1e-12 to 1e4 at either end.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "core/arithmetic.h"
#include "unit/gauss_kronrod.h"

namespace havs {
namespace {

using FloatArithmetic = Arithmetic<FloatLane>;
using DoubleArithmetic = Arithmetic<DoubleLane>;

struct Weights {
  long double front;
  long double back;
  long double alpha;
};

/// Integrals of the positive forms, cut off where the transparency is exp(-200).
Weights positiveForms(long double atFront, long double atBack) {
  const auto slope = [=](long double s) { return atFront * (1 - s) + atBack * s; };
  const auto depth = [=](long double s) { return s * (atFront + slope(s)) / 2; };
  long double end = 1;
  while (depth(end) > 200) end *= 0.75L;
  const auto light = [=](long double s) { return slope(s) * std::exp(-depth(s)); };
  return {test::integrate([=](long double s) { return (1 - s) * light(s); }, 0, end),
          test::integrate([=](long double s) { return s * light(s); }, 0, end), -std::expm1(-(atFront + atBack) / 2)};
}

/// The plain definition: 1 - Psi, Psi - zeta, 1 - zeta. Well conditioned where the depth is not small.
Weights plainDefinition(long double atFront, long double atBack) {
  const long double b = (atBack - atFront) / 2;
  const long double psi = test::integrate([=](long double s) { return std::exp(-s * (atFront + b * s)); }, 0, 1);
  const long double zeta = std::exp(-(atFront + atBack) / 2);
  return {1 - psi, psi - zeta, 1 - zeta};
}

struct Pair {
  double atFront;
  double atBack;
};

/// A grid of 0, 1e-12 ... 1e4 on both sides, two steps a decade and the places where the method changes, and random
/// pairs, evenly in the logarithm.
std::vector<Pair> domain() {
  std::vector<double> values{0};
  for (int i = -24; i <= 8; ++i) values.push_back(std::pow(10.0, i / 2.0));
  for (double v : {0.09, 0.11, 0.9, 1.1, 15.0, 19.9, 20.1, 36.9, 37.1, 73.9, 74.1, 40.1}) values.push_back(v);
  std::vector<Pair> pairs;
  for (double f : values)
    for (double b : values) pairs.push_back({f, b});
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> exponent(-12, 4);
  for (int i = 0; i < 2000; ++i) pairs.push_back({std::pow(10.0, exponent(random)), std::pow(10.0, exponent(random))});
  std::uniform_real_distribution<double> middling(-2, 2.5);
  for (int i = 0; i < 2000; ++i) pairs.push_back({std::pow(10.0, middling(random)), std::pow(10.0, middling(random))});
  return pairs;
}

long double relative(long double value, long double exact) {
  return exact == 0 ? std::fabs(value) : std::fabs(value / exact - 1);
}

template <class W>
long double worstOf(const W& w, const Weights& exact) {
  return std::max({relative(w.front, exact.front), relative(w.back, exact.back), relative(w.alpha, exact.alpha)});
}

TEST(Oracle, IntegratesPolynomialsOfDegree22) {
  EXPECT_NEAR(static_cast<double>(test::kronrod15([](long double s) { return std::pow(s, 22); }, -1, 1) * 23 / 2), 1,
              1e-17);
}

TEST(Integration, WeightsOverTheWholeDomain) {
  long double worstDouble = 0;
  long double worstFloat = 0;
  for (const Pair& p : domain()) {
    worstDouble = std::max(worstDouble, worstOf(DoubleArithmetic::segmentWeights(p.atFront, p.atBack),
                                                positiveForms(p.atFront, p.atBack)));
    const float f = static_cast<float>(p.atFront);
    const float b = static_cast<float>(p.atBack);
    worstFloat = std::max(worstFloat, worstOf(FloatArithmetic::segmentWeights(f, b), positiveForms(f, b)));
  }
  RecordProperty("double", std::to_string(worstDouble * 1e15L) + "e-15");
  RecordProperty("float", std::to_string(worstFloat * 1e7L) + "e-7");
  EXPECT_LE(worstDouble, 1e-13L);  // the goals of docs/02-method.md
  EXPECT_LE(worstFloat, 1e-6L);
}

TEST(Integration, WeightsAgainstThePlainDefinition) {
  long double worst = 0;
  for (const Pair& p : domain()) {
    const double depth = (p.atFront + p.atBack) / 2;
    if (depth < 0.5 || depth > 500) continue;  // below, the definition cancels
    const Weights exact = plainDefinition(p.atFront, p.atBack);
    if (exact.back < 1e-4L || exact.front < 1e-4L) continue;  // Psi - zeta of 1e-19 each
    worst = std::max(worst, worstOf(DoubleArithmetic::segmentWeights(p.atFront, p.atBack), exact));
  }
  EXPECT_LE(worst, 1e-13L);
}

TEST(Integration, ShorterRulesInTheirRange) {
  using A = DoubleArithmetic;
  for (const Pair& p : domain()) {
    const double depth = (p.atFront + p.atBack) / 2;
    const auto exact = A::segmentWeights(p.atFront, p.atBack);
    const Weights reference{exact.front, exact.back, exact.alpha};
    if (depth <= 0.1) {
      EXPECT_LE(worstOf(A::weightsByRule(p.atFront, p.atBack, 0, A::kShallowNodes), reference), 5e-15L);
    }
    if (depth <= 1.0) {
      EXPECT_LE(worstOf(A::weightsByRule(p.atFront, p.atBack, A::kFirstMiddleNode, A::kMiddleNodes), reference),
                2e-14L);
    }
  }
}

template <class Lane>
class IntegrationBounds : public testing::Test {};
using Lanes = testing::Types<FloatLane, DoubleLane>;
TYPED_TEST_SUITE(IntegrationBounds, Lanes);

TYPED_TEST(IntegrationBounds, HoldAlways) {
  using A = Arithmetic<TypeParam>;
  using Real = typename TypeParam::Real;
  std::mt19937_64 random(2);
  std::uniform_real_distribution<double> exponent(-30, 30);  // far outside the domain of accuracy
  std::uniform_real_distribution<double> unit(0, 1);
  for (int i = 0; i < 100000; ++i) {
    const Real f = static_cast<Real>(i % 7 == 0 ? 0.0 : std::pow(10.0, exponent(random)));
    const Real b = static_cast<Real>(i % 11 == 0 ? 0.0 : std::pow(10.0, exponent(random) / 4));
    const auto w = A::segmentWeights(f, b);
    ASSERT_TRUE(w.front >= 0 && w.front <= 1 && w.back >= 0 && w.back <= 1 && w.alpha <= 1) << f << " " << b;
    const typename A::Rgba piece =
        A::linearPiece({Real(1), Real(unit(random)), Real(0), f}, {Real(1), Real(unit(random)), Real(0), b}, Real(1));
    ASSERT_EQ(piece.r, piece.a);  // white stays white
    ASSERT_LE(piece.g, piece.a);  // no colour above its opacity
    ASSERT_EQ(piece.b, 0);
    const typename A::Rgba ends =
        A::trapezoidSegment({Real(1), Real(0), Real(0), f}, {Real(1), Real(0), Real(0), b}, Real(1));
    ASSERT_TRUE(ends.a >= 0 && ends.a <= 1);
    ASSERT_EQ(ends.g, 0);
  }
}

TYPED_TEST(IntegrationBounds, NothingThereGivesNothing) {
  using A = Arithmetic<TypeParam>;
  for (const auto& piece :
       {A::linearPiece({1, 1, 1, 0}, {1, 1, 1, 0}, 1), A::linearPiece({1, 1, 1, 5}, {1, 1, 1, 5}, 0),
        A::trapezoidSegment({1, 1, 1, 0}, {1, 1, 1, 0}, 1)}) {
    EXPECT_EQ(piece.r, 0);
    EXPECT_EQ(piece.a, 0);
  }
}

TEST(Integration, ConstantExtinctionIsTheClosedForm) {
  for (double depth : {1e-12, 1e-6, 1e-3, 0.1, 1.0, 10.0, 100.0, 1e4}) {
    const auto w = DoubleArithmetic::segmentWeights(depth, depth);
    const double back = depth < 0.1 ? depth / 2 - depth * depth / 3 + depth * depth * depth / 8 -
                                          depth * depth * depth * depth / 30  // series of (1 - exp(-d)) / d - exp(-d)
                                    : -std::expm1(-depth) / depth - std::exp(-depth);
    EXPECT_NEAR(w.alpha / -std::expm1(-depth), 1, 2e-14);
    EXPECT_NEAR(w.back / back, 1, 1e-13) << depth;
  }
}

TEST(Integration, ThinLayersInFloatAddUp) {
  // 100,000 layers of optical depth 1e-5 make depth 1. Compositing in double shows the weights alone: 1e-6 is the
  // goal.
  const auto layer = FloatArithmetic::linearPiece({1, 0.5F, 0, 1e-5F}, {1, 0.5F, 0, 1e-5F}, 1);
  DoubleArithmetic::Rgba sum(0, 0, 0, 0);
  FloatArithmetic::Rgba sumFloat(0, 0, 0, 0);
  for (int i = 0; i < 100000; ++i) {
    sum = DoubleArithmetic::compositeUnder(sum, {layer.r, layer.g, layer.b, layer.a});
    sumFloat = FloatArithmetic::compositeUnder(sumFloat, layer);
  }
  const double alpha = -std::expm1(-1.0);
  EXPECT_NEAR(sum.a / alpha, 1, 1e-6);
  EXPECT_NEAR(sum.g / (0.5 * alpha), 1, 1e-6);
  // Composited in float as well, 100,000 roundings of up to 2^-25 walk at random: 2 sigma is 1.1e-5, 1.7e-5 of alpha.
  EXPECT_NEAR(sumFloat.a / alpha, 1, 1.7e-5);
  EXPECT_NEAR(sumFloat.g / (0.5 * alpha), 1, 1.7e-5);
}

TEST(Integration, TrapezoidIsTheOpacityAndTheColourOfEqualEnds) {
  const auto equal = DoubleArithmetic::trapezoidSegment({0.2, 0.4, 0.6, 3}, {0.2, 0.4, 0.6, 3}, 0.5);
  EXPECT_NEAR(equal.a, -std::expm1(-1.5), 1e-15);
  EXPECT_NEAR(equal.g, 0.4 * -std::expm1(-1.5), 1e-15);
  const auto clearFront = DoubleArithmetic::trapezoidSegment({1, 0, 0, 0}, {0, 1, 0, 2}, 1);
  EXPECT_EQ(clearFront.r, 0);  // what does not absorb does not shine
  EXPECT_NEAR(clearFront.g, -std::expm1(-1.0), 1e-15);
}

}  // namespace
}  // namespace havs
