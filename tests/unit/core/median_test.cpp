#include "core/median.h"

#include <gtest/gtest.h>

namespace havs {
namespace {

TEST(Median, IsTheMiddleOfAnOddNumberOfValues) {
  EXPECT_EQ(medianOf({7}), 7);
  EXPECT_EQ(medianOf({9, -1, 4}), 4);
}

TEST(Median, IsTheMeanOfTheTwoInTheMiddleOfAnEvenNumber) {
  EXPECT_EQ(medianOf({1, 100, 2, 4}), 3);
  EXPECT_EQ(medianOf({5, 5, 5, 9}), 5);
}

}  // namespace
}  // namespace havs
