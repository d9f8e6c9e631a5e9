#include "overlay/line_coverage.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace havs {
namespace {

// However a line lies among the pixels across it, they are covered as much as it is wide.
TEST(LineCoverage, OfAllPixelsAcrossALineIsItsWidth) {
  for (const double width : {0.1, 0.5, 1.0, 1.5, 2.0, 7.25})
    for (const double offset : {0.0, 0.125, 0.3, 0.5, 0.99}) {
      double sum = 0;
      for (int i = -10; i <= 10; ++i) sum += lineCoverage(std::abs(i + offset), width);
      EXPECT_NEAR(sum, width, 1e-14) << width << ' ' << offset;
    }
}

TEST(LineCoverage, FallsFromTheMiddleToTheEdge) {
  EXPECT_EQ(lineCoverage(0, 3), 1);
  EXPECT_EQ(lineCoverage(1, 3), 1);
  EXPECT_EQ(lineCoverage(1.5, 3), 0.5);
  EXPECT_EQ(lineCoverage(2, 3), 0);
  EXPECT_EQ(lineCoverage(0, 0.25), 0.25);
  EXPECT_EQ(lineCoverage(100, 3), 0);
}

TEST(PictureLine, DistanceIsToTheNearestPoint) {
  const PictureLine line{1, 1, 5, 4};  // 5 long
  EXPECT_EQ(line.distance(1, 1), 0);
  EXPECT_EQ(line.distance(-2, -3), 5);
  EXPECT_EQ(line.distance(8, 8), 5);
  EXPECT_NEAR(line.distance(3 - 0.6, 2.5 + 0.8), 1, 1e-15);
  const PictureLine point{2, 3, 2, 3};
  EXPECT_EQ(point.distance(5, 7), 5);
}

ScreenPoint at(double x, double y, double w) { return {x * w, y * w, w, w}; }

TEST(LineBetween, EndsJustBeforeTheEye) {
  EXPECT_FALSE(lineBetween(at(1, 2, -1), at(3, 4, 0)));
  const auto whole = lineBetween(at(1, 2, 0.5), at(3, 4, 2));
  ASSERT_TRUE(whole);
  EXPECT_EQ(whole->fromX, 1);
  EXPECT_EQ(whole->toY, 4);
  // Every point of the edge before the eye is on what is left of it, wherever the other end is.
  const ScreenPoint front = at(10, 20, 1), behind = at(-7, 3, -2);
  for (const auto& line : {lineBetween(front, behind), lineBetween(behind, front)}) {
    ASSERT_TRUE(line);
    for (const double share : {0.0, 0.1, 0.3, 0.333}) {
      const double w = 1 - 3 * share;
      const double x = (front.x + share * (behind.x - front.x)) / w, y = (front.y + share * (behind.y - front.y)) / w;
      EXPECT_LT(line->distance(x, y), 1e-8 * (1 + std::hypot(x, y))) << share;
    }
  }
}

TEST(PixelsNear, LeavesNoneOut) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> place(-15, 45);
  constexpr int kWidth = 30;
  for (int i = 0; i < 300; ++i) {
    PictureLine line{place(random), place(random), place(random), place(random)};
    if (i % 5 == 0) line.toY = line.fromY;
    if (i % 7 == 0) line.toX = line.fromX;
    const double reach = 0.5 + i % 4;
    for (int y = 0; y < kWidth; ++y) {
      const auto [first, last] = pixelsNear(line, y, reach, kWidth);
      EXPECT_TRUE(first >= 0 && last < kWidth);
      for (int x = 0; x < kWidth; ++x)
        if (x < first || x > last) {
          EXPECT_GE(line.distance(x + 0.5, y + 0.5), reach) << i << ": " << x << ',' << y;
        }
    }
  }
  EXPECT_LT(pixelsNear({0, 0, 1e9, 1e9}, 40, 1, kWidth).last, 0) << "beside the picture";
}

}  // namespace
}  // namespace havs
