#include "study/fit.h"

#include <gmock/gmock.h>

#include <cmath>

namespace havs {
namespace {

using Points = std::vector<std::array<double, 2>>;
using testing::ElementsAre;

Points madePoints(double order, double constant, double floor, std::vector<double> sizes = {8, 16, 32, 64, 128, 256}) {
  Points points;
  for (const double size : sizes) points.push_back({size, constant * std::pow(size, -order) + floor});
  return points;
}

TEST(FitOrder, FindsTheOrderOfAPowerLaw) {
  for (const double order : {0.5, 1.0, 2.0, 3.0}) {
    const auto fit = fitOrder(madePoints(order, 0.7, 0), 0);
    ASSERT_TRUE(fit);
    EXPECT_NEAR(fit->slope, -order, 1e-12);  // logarithms of numbers of order 1, rounded
    EXPECT_THAT(fit->used, ElementsAre(8, 256));
    EXPECT_NEAR(fit->worstFactor, 1, 1e-12);
  }
}

TEST(FitOrder, DoesNotDependOnTheOrderOfThePoints) {
  Points points = madePoints(2, 1, 1e-6);
  const auto fit = fitOrder(points, 1e-6);
  std::reverse(points.begin(), points.end());
  EXPECT_EQ(fitOrder(points, 1e-6)->slope, fit->slope);
}

/// Ten times above the floor, the floor changes the last of the local slopes by log2(1.1 / 1.025) = 0.1.
TEST(FitOrder, StopsBeforeAFloorThatIsKnown) {
  const Points points = madePoints(2, 1, 1e-4);  // errors 1.6e-2 to 1.2e-4
  const auto fit = fitOrder(points, 1e-4);
  ASSERT_TRUE(fit);
  EXPECT_NEAR(fit->slope, -2, 0.1);
  EXPECT_THAT(fit->used, ElementsAre(8, 32));
}

TEST(FitOrder, StopsWhereTheErrorDoesWhenTheFloorIsNotKnown) {
  const auto fit = fitOrder(madePoints(2, 1, 3e-5), 0);
  ASSERT_TRUE(fit);
  EXPECT_NEAR(fit->slope, -2, 0.2);
  EXPECT_LT(fit->used[1], 256);
}

/// Coarse tables that have not begun to converge are not on the line of the others.
TEST(FitOrder, LeavesOutACoarseStart) {
  Points points = madePoints(2, 100, 0);
  points[0][1] = points[1][1] = points[2][1];
  const auto fit = fitOrder(points, 0);
  ASSERT_TRUE(fit);
  EXPECT_NEAR(fit->slope, -2, 1e-12);
  EXPECT_THAT(fit->used, ElementsAre(32, 256));
}

TEST(FitOrder, NeedsThreeSizes) {
  EXPECT_FALSE(fitOrder({}, 0));
  EXPECT_FALSE(fitOrder(madePoints(2, 1, 0, {8, 16}), 0));
  EXPECT_FALSE(fitOrder(Points{{8, 1}, {8, 0.9}, {16, 0.25}}, 0));                    // two sizes
  EXPECT_FALSE(fitOrder(Points{{8, 1}, {16, 0}, {32, std::nan("")}, {64, 0.1}}, 0));  // two errors
  EXPECT_TRUE(fitOrder(madePoints(2, 1, 0, {8, 16, 32}), 0));
}

TEST(FitOrder, RefusesWhatIsNoLine) { EXPECT_FALSE(fitOrder(Points{{8, 1}, {16, 1e-4}, {32, 0.9e-4}}, 0)); }

}  // namespace
}  // namespace havs
