#include "image/background.h"

#include <gmock/gmock.h>

#include "core/error.h"

namespace havs {
namespace {

TEST(ParseBackground, ReadsEveryWayOfWriting) {
  EXPECT_EQ(parseBackground("none"), std::nullopt);
  EXPECT_EQ(parseBackground("white"), (Color{1, 1, 1}));
  EXPECT_EQ(parseBackground("black"), (Color{0, 0, 0}));
  EXPECT_EQ(parseBackground("#ff0033"), (Color{1, 0, 0.2}));
  EXPECT_EQ(parseBackground("0.25,1,0"), (Color{0.25, 1, 0}));
}

TEST(ParseBackground, RefusesEverythingElse) {
  for (const char* text :
       {"", "whit", "#fff", "#12345g", "#-1-1-1", "0.1,0.2", "0.1,0.2,0.3,0.4", "1,2,0", "nan,0,0", "0,0,0 "})
    EXPECT_THROW(parseBackground(text), Error) << text;
}

TEST(Over, AddsTheBackgroundThatShowsThrough) {
  const float premultiplied[4] = {0.25f, 0.5f, 0, 0.5f};
  EXPECT_THAT(over(premultiplied, {1, 0, 0.5}), testing::ElementsAre(0.75f, 0.5f, 0.25f));
}

TEST(Straight, DividesByAlpha) {
  const float half[4] = {0.25f, 0.5f, 0, 0.5f};
  EXPECT_THAT(straight(half), testing::ElementsAre(0.5f, 1.0f, 0.0f, 0.5f));
  const float clear[4] = {0, 0, 0, 0};
  EXPECT_THAT(straight(clear), testing::ElementsAre(0.0f, 0.0f, 0.0f, 0.0f));
}

}  // namespace
}  // namespace havs
