#include "core/parallel.h"

#include <gtest/gtest.h>

#include <atomic>
#include <vector>

namespace havs {
namespace {

TEST(ParallelFor, VisitsEachIndexOnce) {
  std::vector<std::atomic<int>> visits(10000);
  parallelFor(10, visits.size(), 16, [&](std::size_t i) { ++visits[i]; });
  for (std::size_t i = 0; i < visits.size(); ++i) EXPECT_EQ(visits[i], i < 10 ? 0 : 1) << i;
}

TEST(ParallelBlocks, EmptyRangeCallsNothing) {
  int calls = 0;
  parallelBlocks(5, 5, 1, [&](std::size_t, std::size_t) { ++calls; });
  EXPECT_EQ(calls, 0);
}

TEST(ParallelReduce, JoinsEveryBlockOnce) {
  const std::size_t sum = parallelReduce(
      10, 10000, 16, std::size_t{0},
      [](std::size_t first, std::size_t last) { return (first + last - 1) * (last - first) / 2; },
      [](std::size_t a, std::size_t b) { return a + b; });
  EXPECT_EQ(sum, std::size_t{9999} * 10000 / 2 - std::size_t{9} * 10 / 2);
}

TEST(ParallelReduce, EmptyRangeIsTheIdentity) {
  const auto body = [](std::size_t, std::size_t) { return 1; };
  EXPECT_EQ(parallelReduce(5, 5, 1, -7, body, [](int a, int b) { return a > b ? a : b; }), -7);
}

TEST(ThreadLimit, HoldsWhileItLives) {
  const std::size_t all = threadCount();
  {
    const ThreadLimit one(1);
    EXPECT_EQ(threadCount(), 1u);
  }
  EXPECT_EQ(threadCount(), all);
  const ThreadLimit none(0);
  EXPECT_EQ(threadCount(), all);
}

}  // namespace
}  // namespace havs
