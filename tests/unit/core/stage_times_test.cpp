#include "core/stage_times.h"

#include <gmock/gmock.h>

namespace havs {
namespace {

TEST(StageTimes, MedianOfOddAndEvenCounts) {
  StageTimes times;
  for (double t : {9.0, 1.0, 5.0}) times.add("draw", t);
  for (double t : {4.0, 1.0, 2.0, 100.0}) times.add("sort", t);
  EXPECT_EQ(times.median("draw"), 5);
  EXPECT_EQ(times.median("sort"), 3);
  EXPECT_EQ(times.median("unknown"), 0);
}

TEST(StageTimes, StagesStandInTheOrderOfTheirFirstRun) {
  StageTimes times;
  times.add("b", 1);
  times.add("a", 2);
  times.add("b", 3);
  EXPECT_THAT(times.medians(), testing::ElementsAre(testing::Pair("b", 2), testing::Pair("a", 2)));
}

TEST(ScopedStage, CountsTheTimeOfItsScope) {
  StageTimes times;
  { const ScopedStage stage(times, "wait"); }
  ASSERT_EQ(times.medians().size(), 1u);
  EXPECT_GE(times.median("wait"), 0);
}

}  // namespace
}  // namespace havs
