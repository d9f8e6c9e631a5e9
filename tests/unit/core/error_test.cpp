#include "core/error.h"

#include <gtest/gtest.h>

namespace havs {
namespace {

TEST(Error, SaysWhereWhatAndWhatToTry) {
  EXPECT_STREQ(Error(ErrorKind::input, "no cells", "a.ele", "check the header").what(),
               "a.ele: no cells; check the header");
  EXPECT_STREQ(Error(ErrorKind::input, "no cells").what(), "no cells");
  EXPECT_STREQ(Error(ErrorKind::input, "no cells", "", "check").what(), "no cells; check");
}

TEST(Error, KindDecidesTheExitStatus) {
  try {
    failInput("x");
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::input);
    EXPECT_EQ(error.exitStatus(), 2);
  }
  try {
    failRunning("x");
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::running);
    EXPECT_EQ(error.exitStatus(), 1);
  }
}

}  // namespace
}  // namespace havs
