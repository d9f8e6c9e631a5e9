// integrateSegment and firstOpaque against closed forms and quadrature.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "core/arithmetic.h"
#include "transfer/pieces.h"
#include "transfer/preintegration.h"
#include "unit/gauss_kronrod.h"
#include "unit/transfer/preset_curve.h"

namespace havs {
namespace {

/// The curve of knots with the given extinctions, linear, evenly spaced, white.
ExtinctionCurve curveOf(const std::vector<double>& kappas) {
  ExtinctionCurve curve;
  for (std::size_t i = 0; i < kappas.size(); ++i)
    curve.knots.push_back({static_cast<double>(i) / static_cast<double>(kappas.size() - 1), {1, 1, 1}, kappas[i]});
  return curve;
}

SegmentColor over(const SegmentColor& front, const SegmentColor& back) {
  SegmentColor c = front;
  for (int i = 0; i < 3; ++i) c.color[i] += (1 - front.alpha) * back.color[i];
  c.alpha += (1 - front.alpha) * back.alpha;
  return c;
}

double distance(const SegmentColor& a, const SegmentColor& b) {
  double d = std::abs(a.alpha - b.alpha);
  for (int i = 0; i < 3; ++i) d = std::max(d, std::abs(a.color[i] - b.color[i]));
  return d;
}

/// The definition: integral of c kappa exp(-depth) along the ray, the depth by trapezoids between knots, each smooth
/// stretch by quadrature.
SegmentColor byDefinition(const ExtinctionCurve& curve, double from, double to, double length) {
  std::vector<double> cuts{0, 1};
  for (const auto& k : curve.knots) {
    const double t = (k.s - from) / (to - from);
    if (t > 0 && t < 1) cuts.push_back(t);
  }
  std::sort(cuts.begin(), cuts.end());
  SegmentColor sum;
  long double depthBefore = 0;
  for (std::size_t i = 1; i < cuts.size(); ++i) {
    const long double a = cuts[i - 1], b = cuts[i];
    if (!(a < b)) continue;
    const auto inner = [&](double share) {
      return curve.at(from + (to - from) * std::lerp(cuts[i - 1], cuts[i], share));
    };
    const auto first = inner(1.0 / 3), second = inner(2.0 / 3);  // clear of steps at the ends
    const auto linear = [](double at13, double at23, long double t) { return at13 + (at23 - at13) * (3 * t - 1); };
    const long double stretch = (b - a) * length;
    const auto kappa = [&](long double t) { return linear(first.kappa, second.kappa, t); };
    const auto light = [&](long double t) {
      return stretch * kappa(t) * std::exp(-depthBefore - stretch * t * (kappa(0) + kappa(t)) / 2);
    };
    for (int c = 0; c < 3; ++c) {
      sum.color[c] += static_cast<double>(test::integrate(
          [&](long double t) { return light(t) * linear(first.color[c], second.color[c], t); }, 0, 1, 12));
    }
    depthBefore += stretch * kappa(0.5L);
  }
  sum.alpha = static_cast<double>(-std::expm1(-depthBefore));
  return sum;
}

TEST(Segment, ConstantExtinction) {
  for (double kappa : {1e-9, 1e-3, 1.0, 50.0}) {
    const ExtinctionCurve curve = curveOf({kappa, kappa, kappa});
    for (auto [from, to] : {std::pair{0.3, 0.3}, {0.1, 0.9}, {1.0, 0.0}, {0.5, 1.0}}) {
      const SegmentColor c = integrateSegment(curve, from, to, 0.7);
      EXPECT_NEAR(c.alpha / -std::expm1(-0.7 * kappa), 1, 1e-13);
      EXPECT_NEAR(c.color[1], c.alpha, 1e-15);
    }
  }
}

/// A piece between (kappa, colour) at both ends by the integrals of its weights.
Rgba pieceByQuadrature(const Rgba& front, const Rgba& back, double length) {
  const long double atFront = static_cast<long double>(front.a) * length,
                    atBack = static_cast<long double>(back.a) * length;
  const auto weight = [&](bool ofBack) {
    return static_cast<double>(test::integrate(
        [&](long double s) {
          const long double slope = atFront * (1 - s) + atBack * s;
          return (ofBack ? s : 1 - s) * slope * std::exp(-s * (atFront + slope) / 2);
        },
        0, 1));
  };
  const double f = weight(false), b = weight(true);
  return {f * front.r + b * back.r, f * front.g + b * back.g, f * front.b + b * back.b, f + b};
}

TEST(Segment, PiecesKeepTheirRelativeAccuracyAtEveryDepth) {
  double worst = 0;
  for (int exponent = -40; exponent <= 16; ++exponent)
    for (const double share : {0.0, 1e-6, 0.1, 0.4, 0.5, 0.8, 1.0}) {
      const double depth = std::exp2(0.5 * exponent);  // past the ends of the rules for thin and for middling pieces
      const Rgba front(1, 0, 0.5, 2 * depth * share), back(0, 1, 0.5, 2 * depth * (1 - share));
      const Rgba found = integratePiece(front, back, 1), expected = pieceByQuadrature(front, back, 1);
      for (const auto& [f, e] : {std::pair{found.r, expected.r}, {found.g, expected.g}, {found.a, expected.a}})
        worst = std::max(worst, std::abs(f / e - 1));
    }
  EXPECT_LE(worst, 1e-13);  // the weights' own bound (arithmetic_integration_test.cpp)
}

TEST(Segment, RisingRampIsTheErfForm) {
  // kappa = K s, colour (s, 1 - s, 0): Psi = sqrt(pi / (4 b)) erf(sqrt(b)) with b = K L / 2.
  for (double b : {0.3, 2.0, 20.0}) {
    ExtinctionCurve curve;
    curve.knots = {{0, {0, 1, 0}, 0}, {1, {1, 0, 0}, 2 * b}};
    const SegmentColor c = integrateSegment(curve, 0, 1, 1);
    const double psi = std::sqrt(std::numbers::pi / (4 * b)) * std::erf(std::sqrt(b));
    EXPECT_NEAR(c.color[0], psi - std::exp(-b), 1e-14);
    EXPECT_NEAR(c.color[1], 1 - psi, 1e-14);
    EXPECT_NEAR(c.alpha, 1 - std::exp(-b), 1e-14);
  }
}

TEST(Segment, FallingRampIsTheDawsonForm) {
  // kappa = K (1 - s): Psi = exp(-b) integral 0..1 of exp(b s^2) ds = D(sqrt(b)) / sqrt(b), D Dawson's integral by its
  // series.
  for (double b : {0.3, 2.0, 10.0}) {
    ExtinctionCurve curve;
    curve.knots = {{0, {0, 1, 0}, 0}, {1, {1, 0, 0}, 2 * b}};
    const SegmentColor c = integrateSegment(curve, 1, 0, 1);
    long double term = 1, psi = 0;
    for (int n = 0; n < 120; ++n, term *= b / n) psi += term / (2 * n + 1);
    psi *= std::exp(static_cast<long double>(-b));
    EXPECT_NEAR(c.color[0], static_cast<double>(1 - psi), 1e-14);
    EXPECT_NEAR(c.color[1], static_cast<double>(psi) - std::exp(-b), 1e-14);
  }
}

TEST(Segment, PresetsAgainstTheDefinition) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> unit(0, 1);
  for (const TransferPreset& preset : transferPresets()) {
    const ExtinctionCurve curve = presetCurve(preset.name);
    double worst = 0;
    for (int i = 0; i < 12; ++i) {
      const double from = unit(random), to = unit(random), length = 0.5 * unit(random);
      worst =
          std::max(worst, distance(integrateSegment(curve, from, to, length), byDefinition(curve, from, to, length)));
    }
    EXPECT_LE(worst, 1e-12) << preset.name;
  }
}

TEST(Segment, StepsInTheMiddleAndAtTheEnds) {
  ExtinctionCurve curve;
  curve.knots = {{0, {1, 0, 0}, 1}, {0.5, {1, 0, 0}, 1}, {0.5, {0, 0, 1}, 3}, {1, {0, 0, 1}, 3}};
  const double red = -std::expm1(-0.5), blue = -std::expm1(-1.5);
  const SegmentColor up = integrateSegment(curve, 0, 1, 1);
  EXPECT_NEAR(up.color[0], red, 1e-15);
  EXPECT_NEAR(up.color[2], std::exp(-0.5) * blue, 1e-15);
  const SegmentColor down = integrateSegment(curve, 1, 0, 1);
  EXPECT_NEAR(down.color[2], blue, 1e-15);
  EXPECT_NEAR(down.color[0], std::exp(-1.5) * red, 1e-15);
  EXPECT_EQ(integrateSegment(curve, 0.2, 0.5, 1).color[2], 0);  // up to the step, from below
  EXPECT_EQ(integrateSegment(curve, 0.5, 0.2, 1).color[2], 0);
  EXPECT_EQ(integrateSegment(curve, 0.5, 0.8, 1).color[0], 0);  // and from above
  EXPECT_EQ(integrateSegment(curve, 0.8, 0.5, 1).color[0], 0);
  EXPECT_EQ(integrateSegment(curve, 0.5, 0.5, 1).color[0], 0);  // on it, the upper side
}

TEST(Segment, NearlyEqualScalarsGoOverIntoEqualOnes) {
  const ExtinctionCurve curve = presetCurve("viridis");
  const SegmentColor equal = integrateSegment(curve, 0.4, 0.4, 0.2);
  for (double step : {1e-8, 1e-12, 5e-17 * 2, 1e-300}) {
    EXPECT_LE(distance(integrateSegment(curve, 0.4, 0.4 + step, 0.2), equal), 10 * step + 1e-14);
    EXPECT_LE(distance(integrateSegment(curve, 0.4 + step, 0.4, 0.2), equal), 10 * step + 1e-14);
  }
  EXPECT_LE(distance(integrateSegment(curve, 0, 1e-310, 0.2), integrateSegment(curve, 0, 0, 0.2)), 1e-14);
}

TEST(Segment, IsTheCompositeOfItsHalvesAndItsAlphaIsSymmetric) {
  std::mt19937_64 random(6);
  std::uniform_real_distribution<double> unit(0, 1);
  for (const TransferPreset& preset : transferPresets()) {
    const ExtinctionCurve curve = presetCurve(preset.name);
    for (int i = 0; i < 100; ++i) {
      const double from = unit(random), to = unit(random), length = unit(random), share = unit(random);
      const double middle = std::lerp(from, to, share);
      const SegmentColor whole = integrateSegment(curve, from, to, length);
      const SegmentColor halves = over(integrateSegment(curve, from, middle, share * length),
                                       integrateSegment(curve, middle, to, (1 - share) * length));
      EXPECT_LE(distance(whole, halves), 1e-12) << preset.name;  // the cut's rounding, times slopes of up to 1e4
      EXPECT_NEAR(whole.alpha, integrateSegment(curve, to, from, length).alpha, 1e-13);
      for (double c : whole.color) EXPECT_TRUE(c >= 0 && c <= whole.alpha && whole.alpha <= 1);
    }
  }
}

TEST(Segment, TheExercisesRiemannSumComesNear) {
  // Seed of the exercise: front 64, back 112 in unit steps, opacity corrected to one of `steps` parts of a unit length.
  const TransferFunction f = loadTransferFunction("plateau-opaque");
  constexpr int kFront = 64, kBack = 112, kSteps = kBack - kFront;
  SegmentColor riemann;
  for (int s = kFront; s < kBack; ++s) {
    const ControlPoint p = evaluate(f, s / 255.0);
    SegmentColor sample{p.color, 1 - std::pow(1 - p.opacity, 1.0 / kSteps)};
    for (double& c : sample.color) c *= sample.alpha;
    riemann = over(riemann, sample);
  }
  const double unitLength = 0.1;  // default: diagonal 2 / 20
  const SegmentColor exact = integrateSegment(presetCurve("plateau-opaque"), kFront / 255.0, kBack / 255.0, unitLength);
  const double leftRule =
      std::log(4.0) / (2 * kSteps);  // half the rise of the extinction, ln 4 at opacity 3/4, over the steps
  EXPECT_NEAR(riemann.alpha, exact.alpha, 1.1 * leftRule);
  EXPECT_LT(riemann.alpha, exact.alpha);
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(riemann.color[c], exact.color[c], 1.1 * leftRule);
  EXPECT_NEAR(integrateSegment(presetCurve("plateau-opaque"), 0.6, 0.6, unitLength).alpha, 1,
              0x1p-23);  // the plateau, capped
}

TEST(FirstOpaque, FindsTheFirstIntervalOnTheWay) {
  ExtinctionCurve curve;
  curve.opaque = {{0.2, 0.3}, {0.6, 0.6}};
  EXPECT_DOUBLE_EQ(firstOpaque(curve, 0.1, 0.6), 0.2);
  EXPECT_DOUBLE_EQ(firstOpaque(curve, 0.9, 0.1), 0.375);
  EXPECT_DOUBLE_EQ(firstOpaque(curve, 0.5, 0.1), 0.5);  // from above: the upper end first
  EXPECT_EQ(firstOpaque(curve, 0.25, 0.9), 0);
  EXPECT_EQ(firstOpaque(curve, 0.3, 0.3), 0);
  EXPECT_EQ(firstOpaque(curve, 0.6, 0.5), 0);
  EXPECT_EQ(firstOpaque(curve, 0.1, 0.2), 1);
  EXPECT_GT(firstOpaque(curve, 0.1, 0.19), 1);
  EXPECT_GT(firstOpaque(curve, 0.35, 0.55), 1);
  EXPECT_GT(firstOpaque(curve, 0.1, 0.1), 1);
  EXPECT_GT(firstOpaque(ExtinctionCurve{}, 0, 1), 1);
}

TEST(PostSegment, FloatAndDoubleOfOneSourceAgree) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<float> unit(0, 1);
  double worst = 0;
  for (int i = 0; i < 20000; ++i) {
    const float r = unit(random), kf = 30 * unit(random), kb = 30 * unit(random), length = unit(random);
    const auto f = Arithmetic<FloatLane>::trapezoidSegment({r, 1, 0, kf}, {1, r, 0, kb}, length);
    const auto d = Arithmetic<DoubleLane>::trapezoidSegment({r, 1, 0, kf}, {1, r, 0, kb}, length);
    worst = std::max({worst, std::abs(f.r - d.r), std::abs(f.g - d.g), std::abs(f.a - d.a)});
  }
  EXPECT_LE(worst, 4 * 0x1p-24);  // four roundings of numbers up to 1
}

}  // namespace
}  // namespace havs
