#include "image/axis.h"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>

#include "core/error.h"

namespace havs {
namespace {

std::vector<std::string> labelsOf(const Axis& axis, int most = 8) {
  std::vector<std::string> labels;
  for (const Tick& tick : ticksOf(axis, most))
    if (!tick.label.empty()) labels.push_back(tick.label);
  return labels;
}

TEST(Ticks, LinearAtOneTwoFive) {
  EXPECT_THAT(labelsOf({0, 1}), testing::ElementsAre("0", "0.2", "0.4", "0.6", "0.8", "1"));
  EXPECT_THAT(labelsOf({0, 0.011}), testing::ElementsAre("0", "0.002", "0.004", "0.006", "0.008", "0.01"));
  EXPECT_THAT(labelsOf({-3, 4}), testing::ElementsAre("-3", "-2", "-1", "0", "1", "2", "3", "4"));
  EXPECT_THAT(labelsOf({0, 3e-6}, 4), testing::ElementsAre("0", "10⁻⁶", "2×10⁻⁶", "3×10⁻⁶"));
  EXPECT_THAT(labelsOf({1000.25, 1000.5}, 3), testing::ElementsAre("1000.4"));
}

TEST(Ticks, LogarithmicAtPowersOfTen) {
  EXPECT_THAT(labelsOf({1e-3, 10, true}), testing::ElementsAre("10⁻³", "10⁻²", "10⁻¹", "1", "10¹"));
  EXPECT_THAT(labelsOf({1e-7, 0.11, true}, 8),
              testing::ElementsAre("10⁻⁷", "10⁻⁶", "10⁻⁵", "10⁻⁴", "10⁻³", "10⁻²", "10⁻¹"));
  EXPECT_THAT(labelsOf({1e-7, 0.11, true}, 4), testing::ElementsAre("10⁻⁶", "10⁻⁴", "10⁻²"));
}

TEST(Ticks, LogarithmicOfLessThanADecadeHasLinearSteps) {
  EXPECT_THAT(labelsOf({0.2, 0.6, true}, 5), testing::ElementsAre("0.2", "0.3", "0.4", "0.5", "0.6"));
}

TEST(Ticks, MinorOnesFillTheDecades) {
  const auto ticks = ticksOf({0.5, 20, true});
  std::vector<double> values;
  for (const Tick& tick : ticks) values.push_back(tick.value);
  EXPECT_THAT(values, testing::Pointwise(testing::DoubleNear(1e-12), {0.5, 0.6, 0.7, 0.8, 0.9, 1.0, 2.0, 3.0, 4.0, 5.0,
                                                                      6.0, 7.0, 8.0, 9.0, 10.0, 20.0}));
  for (const Tick& tick : ticks) EXPECT_EQ(tick.label.empty(), tick.value != 1 && tick.value != 10) << tick.value;
}

/// Ascending, on the axis, where position() says, and never more labels than asked for.
TEST(Ticks, OfManyAxes) {
  for (const bool logarithmic : {false, true})
    for (double low = 1e-9; low < 1e4; low *= 7.3)
      for (double factor = 1.05; factor < 1e8; factor *= 3.1)
        for (const int most : {2, 5, 8}) {
          const Axis axis{low, low * factor, logarithmic};
          const auto ticks = ticksOf(axis, most);
          int labels = 0;
          double before = -1;
          for (const Tick& tick : ticks) {
            labels += tick.label.empty() ? 0 : 1;
            EXPECT_GT(tick.position, before);
            EXPECT_NEAR(tick.position, axis.position(tick.value), 2e-9);
            before = tick.position;
          }
          EXPECT_LE(before, 1);
          EXPECT_LE(labels, most) << low << " " << factor << " " << logarithmic;
        }
}

TEST(Ticks, RefuseWhatIsNoAxis) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const Axis& axis : {Axis{1, 1}, Axis{2, 1}, Axis{0, 1, true}, Axis{-1, 1, true}, Axis{0, nan}, Axis{nan, 1},
                           Axis{0, std::numeric_limits<double>::infinity()}})
    EXPECT_THROW(ticksOf(axis), Error);
}

TEST(Axis, PositionOfValues) {
  EXPECT_EQ((Axis{2, 6}).position(3), 0.25);
  EXPECT_NEAR((Axis{1e-4, 1, true}).position(0.1), 0.75, 1e-15);
  EXPECT_EQ((Axis{1e-4, 1, true}).position(0), -std::numeric_limits<double>::infinity());
}

TEST(NumberLabel, IsShortAndPlain) {
  EXPECT_EQ(numberLabel(0), "0");
  EXPECT_EQ(numberLabel(0.1097), "0.11");
  EXPECT_EQ(numberLabel(0.00123456), "0.00123");
  EXPECT_EQ(numberLabel(1500), "1500");
  EXPECT_EQ(numberLabel(-2.5e-6), "-2.5×10⁻⁶");
  EXPECT_EQ(numberLabel(1e-7), "10⁻⁷");
  EXPECT_EQ(numberLabel(9.9999e-5), "10⁻⁴");
  EXPECT_EQ(numberLabel(3.14e12), "3.14×10¹²");
}

}  // namespace
}  // namespace havs
