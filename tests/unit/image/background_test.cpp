#include "image/background.h"

#include <gmock/gmock.h>

#include "core/error.h"
#include "support/temporary_folder.h"

namespace havs {
namespace {

TEST(ParseBackground, ReadsEveryWayOfWriting) {
  EXPECT_EQ(parseBackground("none"), std::nullopt);
  EXPECT_EQ(parseBackground("white"), (Color{1, 1, 1}));
  EXPECT_EQ(parseBackground("black"), (Color{0, 0, 0}));
  EXPECT_EQ(parseBackground("#ff0033"), (Color{1, 0, 0.2}));
  EXPECT_EQ(parseBackground("0.25,1,0"), (Color{0.25, 1, 0}));
}

TEST(ParseBackground, ReadsGradients) {
  EXPECT_EQ(parseBackground("black..white"), (Background{{0, 0, 0}, {1, 1, 1}}));
  EXPECT_EQ(parseBackground("#ff0033..0,0.5,1"), (Background{{1, 0, 0.2}, {0, 0.5, 1}}));
}

// Linear in the height of the pixels' middles, which lie half a pixel from the edges that have the colours themselves.
TEST(Background, GoesFromTheLowerEdgeToTheUpperOne) {
  const Background gradient{{1, 0, 0.5}, {0, 1, 0.5}};
  EXPECT_EQ(gradient.at(3, 4), (Color{0.875, 0.125, 0.5}));
  EXPECT_EQ(gradient.at(0, 4), (Color{0.125, 0.875, 0.5}));
  EXPECT_EQ(gradient.at(0, 1), (Color{0.5, 0.5, 0.5}));
  EXPECT_EQ(Background(Color{0.1, 0.2, 0.3}).at(2, 7), (Color{0.1, 0.2, 0.3})) << "one colour stays as it is";
}

TEST(Background, IsBehindPng) {
  const test::TemporaryFolder folder;
  const Image image{1, 2, {0, 0, 0, 0, 0.25f, 0, 0, 0.5f}};
  writeImage(image, folder / "a.png", {Background{{0, 0, 1}, {0, 0, 0}}, 16});
  const Image read = readImage(folder / "a.png");
  EXPECT_NEAR(read.pixel(0, 0)[2], 0.25, 1e-5);
  EXPECT_NEAR(read.pixel(0, 1)[0], 0.25, 1e-5);
  EXPECT_NEAR(read.pixel(0, 1)[2], 0.375, 1e-5);
  writeImage(image, folder / "a.pfm", {Background{{0, 0, 1}, {0, 0, 0}}, 8});
  EXPECT_EQ(readImage(folder / "a.pfm").pixel(0, 1)[2], 0.375f);
}

TEST(ParseBackground, RefusesEverythingElse) {
  for (const char* text :
       {"", "whit", "#fff", "#12345g", "#-1-1-1", "0.1,0.2", "0.1,0.2,0.3,0.4", "1,2,0", "nan,0,0", "0,0,0 ", "black..",
        "..black", "none..black", "black..none", "black...white", "black..white..red"})
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
