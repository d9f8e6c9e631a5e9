#include "study/front.h"

#include <gmock/gmock.h>

#include <limits>
#include <random>

namespace havs {
namespace {

using testing::ElementsAre;

TEST(NonDominated, KeepsWhatNothingBeatsInBoth) {
  const std::vector<CostError> points{{1, 10}, {2, 5}, {2, 6}, {3, 5}, {4, 1}, {5, 2}};
  EXPECT_THAT(nonDominated(points), ElementsAre(true, true, false, false, true, false));
}

TEST(NonDominated, KeepsEqualsTogether) {
  const std::vector<CostError> points{{2, 1}, {1, 3}, {2, 1}, {1, 3}, {2, 3}};
  EXPECT_THAT(nonDominated(points), ElementsAre(true, true, true, true, false));
}

TEST(NonDominated, LeavesOutWhatIsNotFinite) {
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinite = std::numeric_limits<double>::infinity();
  const std::vector<CostError> points{{nan, 0}, {1, 2}, {0, infinite}, {0, nan}};
  EXPECT_THAT(nonDominated(points), ElementsAre(false, true, false, false));
  EXPECT_TRUE(nonDominated({}).empty());
}

/// Against the definition, pair by pair; values from a small set, so that many are equal.
TEST(NonDominated, IsWhatItsDefinitionSays) {
  std::mt19937 random(3);
  for (int trial = 0; trial < 200; ++trial) {
    std::vector<CostError> points(12);
    for (CostError& point : points) point = {static_cast<double>(random() % 5), static_cast<double>(random() % 5)};
    const auto on = nonDominated(points);
    for (std::size_t i = 0; i < points.size(); ++i) {
      bool dominated = false;
      for (const CostError& other : points)
        dominated = dominated || (other.cost <= points[i].cost && other.error <= points[i].error &&
                                  (other.cost < points[i].cost || other.error < points[i].error));
      EXPECT_EQ(on[i], !dominated);
    }
  }
}

TEST(BestOf, TakesFrontAfterFront) {
  const std::vector<CostError> points{{3, 3}, {1, 1}, {2, 2}, {4, 0}};
  EXPECT_THAT(bestOf(points, 2), ElementsAre(1, 3));
  EXPECT_THAT(bestOf(points, 3), ElementsAre(1, 3, 2));
  EXPECT_THAT(bestOf(points, 10), ElementsAre(1, 3, 2, 0));
  EXPECT_TRUE(bestOf(points, 0).empty());
}

TEST(BestOf, SpreadsOverAFrontThatIsTooLong) {
  std::vector<CostError> points;
  for (int i = 0; i <= 10; ++i) points.push_back({static_cast<double>(i), 10.0 - i});
  EXPECT_THAT(bestOf(points, 3), ElementsAre(0, 5, 10));
}

}  // namespace
}  // namespace havs
