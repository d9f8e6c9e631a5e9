#include "transfer/extinction_curve.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/error.h"

namespace havs {
namespace {

double unitDepth(double opacity) { return -std::log1p(-std::min(opacity, 1 - 0x1p-24)); }

TEST(ExtinctionCurve, NormalisesDomainsAtTheLimitsOfADouble) {
  for (const double end : {1e308, 1e-307, 0x1p-1073}) {
    SCOPED_TRACE(end);
    const ExtinctionCurve curve = makeCurve({.points = {{0, {}, 0.5}}}, {.fieldRange = {-end, end}});
    EXPECT_EQ(curve.normalise(-end), 0);
    EXPECT_EQ(curve.normalise(0), 0.5);
    EXPECT_EQ(curve.normalise(end / 2), 0.75);
    EXPECT_EQ(curve.normalise(end), 1);
  }
}

TEST(ExtinctionCurve, PerUnitStaysWithinTheToleranceEverywhere) {
  for (double tolerance : {1e-2, 1e-4, 1e-6}) {
    for (const TransferFunction& f :
         {TransferFunction{.points = {{0, {}, 0}, {1, {}, 1}}}, TransferFunction{.points = {{0, {}, 1}, {1, {}, 0}}},
          TransferFunction{.points = {{0, {}, 0.2}, {0.7, {}, 0.9}, {1, {}, 0.899}}}}) {
      const ExtinctionCurve curve = makeCurve(f, {.boundingDiagonal = 20, .radius = 1, .tolerance = tolerance});
      double worst = 0;
      for (int i = 1; i < 100000; ++i) {
        const double exact = unitDepth(evaluate(f, i / 1e5).opacity);
        worst = std::max(worst, std::abs(curve.at(i / 1e5).kappa / exact - 1));
      }
      EXPECT_LE(worst, tolerance);
      EXPECT_GE(worst, tolerance / 20);  // not many more knots than it takes
    }
  }
}

TEST(ExtinctionCurve, KappaIsPerLocalUnit) {
  const TransferFunction f{.points = {{0, {}, 0.5}, {1, {}, 0.5}}};
  const ExtinctionCurve curve = makeCurve(f, {.boundingDiagonal = 60, .radius = 30});
  EXPECT_DOUBLE_EQ(curve.unitLength, 3);  // diagonal / 20
  EXPECT_DOUBLE_EQ(curve.at(0.5).kappa, std::log(2.0) / 3 * 30);
  EXPECT_EQ(curve.knots.size(), 2u);  // constant opacity needs no more
}

TEST(ExtinctionCurve, ResultDoesNotDependOnTheUnitOfTheMesh) {
  const TransferFunction f = loadTransferFunction("three-peaks");
  const ExtinctionCurve metres = makeCurve(f, {.boundingDiagonal = 2, .radius = 1});
  const ExtinctionCurve millimetres = makeCurve(f, {.boundingDiagonal = 2000, .radius = 1000});
  ASSERT_EQ(metres.knots.size(), millimetres.knots.size());
  for (std::size_t i = 0; i < metres.knots.size(); ++i)
    EXPECT_NEAR(metres.knots[i].kappa, millimetres.knots[i].kappa, 1e-12);
}

TEST(ExtinctionCurve, ExtinctionIsExact) {
  TransferFunction f{.points = {{0, {}, 0.5}, {0.5, {}, 7}, {1, {}, 0}}, .meaning = OpacityMeaning::extinction};
  f.unitLength = 0.25;
  const ExtinctionCurve curve = makeCurve(f, {.radius = 2});
  ASSERT_EQ(curve.knots.size(), 3u);
  EXPECT_EQ(curve.knots[1].kappa, 56);
  EXPECT_EQ(curve.maximumKappa, 56);
  EXPECT_TRUE(curve.opaque.empty());
}

TEST(ExtinctionCurve, OpaqueIntervalsAreClosedAndJoined) {
  const TransferFunction f{.points = {{0, {}, 0},
                                      {0.2, {}, 1},
                                      {0.3, {}, 1},
                                      {0.4, {}, 1},
                                      {0.5, {}, 0},
                                      {0.7, {}, 1},
                                      {0.7, {}, 0},
                                      {0.9, {}, 0.5},
                                      {0.9, {}, 1}}};
  const ExtinctionCurve curve = makeCurve(f, {});
  const double lowered = 1 - 0x1p-21;  // of a step
  EXPECT_THAT(curve.opaque,
              testing::ElementsAre(testing::ElementsAre(0.2, 0.4), testing::ElementsAre(0.7 * lowered, 0.7 * lowered),
                                   testing::ElementsAre(0.9 * lowered, 1.0)));
  EXPECT_DOUBLE_EQ(curve.maximumKappa, 24 * std::log(2.0) / 0.1);  // the cap 1 - 2^-24, unit length 2 / 20
}

TEST(ExtinctionCurve, OpaqueIntervalsAreBridgedByWhatLiesBesideThem) {
  const TransferFunction f{.points = {{0, {}, 0},
                                      {0.3, {}, 0.2},
                                      {0.3, {}, 1},
                                      {0.5, {}, 1},
                                      {0.5, {}, 0.4},
                                      {0.8, {}, 0},
                                      {0.8, {}, 1},
                                      {1, {}, 1}}};
  const ExtinctionCurve curve = makeCurve(f, {});
  const ExtinctionCurve seen = withoutOpaque(curve);
  EXPECT_TRUE(seen.opaque.empty());
  const double perUnit = 1 / 0.1;  // unit length 2 / 20
  EXPECT_NEAR(seen.at(curve.opaque[0][0]).kappa, -std::log(0.8) * perUnit, 1e-12);
  EXPECT_NEAR(seen.at(curve.opaque[0][1]).kappa, -std::log(0.6) * perUnit, 1e-12);
  EXPECT_NEAR(seen.at(0.9).kappa, 0, 1e-12);
  for (double s : {0.0, 0.1, 0.2, 0.6, 0.7}) EXPECT_EQ(seen.at(s).kappa, curve.at(s).kappa) << s;
}

TEST(ExtinctionCurve, WhollyOpaqueBridgesToNothing) {
  const TransferFunction f{.points = {{0, {}, 1}, {1, {}, 1}}};
  EXPECT_EQ(withoutOpaque(makeCurve(f, {})).at(0.5).kappa, 0);
}

TEST(ExtinctionCurve, StepsAreKept) {
  const TransferFunction f{
      .points = {{0, {1, 0, 0}, 0.1}, {0.5, {1, 0, 0}, 0.1}, {0.5, {0, 0, 1}, 0.3}, {1, {0, 0, 1}, 0.3}}};
  const ExtinctionCurve curve = makeCurve(f, {});
  ASSERT_EQ(curve.knots.size(), 4u);
  EXPECT_EQ(curve.knots[1].s, curve.knots[2].s);
  EXPECT_EQ(curve.at(0.5).color[2], 1);  // the upper side
  EXPECT_EQ(curve.at(0.5 * (1 - 0x1p-20)).color[2], 0);
}

// Labels of 0 to `most` at their own steps, as float rounds and interpolates them: the upper side.
TEST(ExtinctionCurve, DataAtAStepAreOnItsUpperSideInFloat) {
  for (const int most : {2, 3, 7, 10, 255, 1000}) {
    TransferFunction f{.normalised = false};
    for (int i = 1; i <= most; ++i)
      for (const int side : {i - 1, i})
        f.points.push_back({static_cast<double>(i), {static_cast<double>(side) / most, 0, 0}, 0.5});
    const ExtinctionCurve curve = makeCurve(f, {.fieldRange = {0, static_cast<double>(most)}});
    for (int i = 0; i <= most; ++i) {
      const auto s = static_cast<float>(curve.normalise(i));
      const float below = std::nextafter(std::nextafter(s, 0.0f), 0.0f);
      for (const float rounded : {s, below})
        EXPECT_DOUBLE_EQ(curve.at(static_cast<double>(rounded)).color[0], static_cast<double>(i) / most) << i;
      if (i > 0) EXPECT_DOUBLE_EQ(curve.at(static_cast<double>(s) * (1 - 1e-6)).color[0], (i - 1.0) / most) << i;
    }
  }
}

TEST(ExtinctionCurve, DataScaleOverMoreThanTheLargestDouble) {
  const double most = std::numeric_limits<double>::max();
  const TransferFunction f{.points = {{-most, {0, 0, 0}, 0.1}, {0, {1, 0, 0}, 0.1}, {most, {1, 1, 1}, 0.1}},
                           .normalised = false};
  const ExtinctionCurve curve = makeCurve(f, {.fieldRange = {-most, most}});
  ASSERT_EQ(curve.knots.front().s, 0);
  ASSERT_EQ(curve.knots.back().s, 1);
  EXPECT_DOUBLE_EQ(curve.at(curve.normalise(0)).color[0], 1);
  EXPECT_DOUBLE_EQ(curve.at(curve.normalise(most / 2)).color[1], 0.5);
  EXPECT_DOUBLE_EQ(evaluate(f, -most / 2).color[0], 0.5);
}

TEST(ExtinctionCurve, DataScaleIsCutToTheDomain) {
  TransferFunction f{.points = {{0, {0, 0, 0}, 0.1}, {100, {1, 1, 1}, 0.1}}, .normalised = false};
  const ExtinctionCurve curve = makeCurve(f, {.fieldRange = {25, 150}});
  EXPECT_EQ(curve.knots.front().s, 0);
  EXPECT_EQ(curve.knots.back().s, 1);
  EXPECT_DOUBLE_EQ(curve.at(0).color[0], 0.25);
  EXPECT_DOUBLE_EQ(curve.at(curve.normalise(50)).color[0], 0.5);
  EXPECT_EQ(curve.at(curve.normalise(140)).color[0], 1);
  f.domain = {50, 60};
  const ExtinctionCurve narrow = makeCurve(f, {.fieldRange = {25, 150}});
  EXPECT_EQ(narrow.domain, (std::array{50.0, 60.0}));
  EXPECT_DOUBLE_EQ(narrow.at(1).color[0], 0.6);
  EXPECT_EQ(narrow.normalise(-1e9), 0);
}

TEST(ExtinctionCurve, FieldOfOneValue) {
  const TransferFunction data{.points = {{0, {0, 0, 0}, 0}, {10, {1, 1, 1}, 0.5}}, .normalised = false};
  const ExtinctionCurve curve = makeCurve(data, {.fieldRange = {5, 5}});
  EXPECT_EQ(curve.normalise(5), 0.5);
  EXPECT_DOUBLE_EQ(curve.at(0.5).color[0], 0.5);
  EXPECT_DOUBLE_EQ(curve.at(0.5).kappa, -std::log(0.75) / 0.1);
  EXPECT_DOUBLE_EQ(makeCurve(loadTransferFunction("grayscale"), {.fieldRange = {5, 5}}).at(0.5).color[0], 0.5);
}

TEST(ExtinctionCurve, RefusesWhatMakesNoSense) {
  TransferFunction f = loadTransferFunction("rainbow");
  EXPECT_THROW(makeCurve(f, {.boundingDiagonal = 0}), Error);
  f.unitLength = -1;
  EXPECT_THROW(makeCurve(f, {}), Error);
  f.unitLength = 1;
  f.domain = {3, 3};
  EXPECT_THROW(makeCurve(f, {}), Error);
  EXPECT_THROW(makeCurve(TransferFunction{}, {}), Error);
}

}  // namespace
}  // namespace havs
