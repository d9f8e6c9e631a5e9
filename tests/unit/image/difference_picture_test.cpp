#include "image/difference_picture.h"

#include <gmock/gmock.h>

#include "core/error.h"
#include "core/parallel.h"
#include "unit/image/pictures.h"

namespace havs {
namespace {

using test::constantImage;
using test::madeImage;

const std::vector<Color> kBlackToGreen{{0, 0, 0}, {0, 1, 0}};

/// Off by 10^-x in channel y, x from 0 to 7, y from 0 to 3.
Image powersOfTen() {
  return madeImage(8, 4, [](int x, int y, int c) { return c == y ? std::pow(10.0, -x) : 0.0; });
}
const Image kBlack = constantImage(8, 4, 0);

/// The table of colours has 4096 steps.
constexpr double kStep = 1.0 / 4096;

TEST(DifferencePicture, LogarithmicFromTenMillionthToTheGreatest) {
  const DifferencePicture shown = differencePicture(powersOfTen(), kBlack, {}, {.colors = kBlackToGreen});
  EXPECT_EQ(shown.scale.axis.low, 1e-7);
  EXPECT_EQ(shown.scale.axis.high, 1);
  EXPECT_TRUE(shown.scale.axis.logarithmic);
  for (int y = 0; y < 4; ++y)
    for (int x = 0; x < 8; ++x) {
      EXPECT_NEAR(shown.image.pixel(x, y)[1], 1 - x / 7.0, kStep) << x << "," << y;
      EXPECT_EQ(shown.image.pixel(x, y)[0], 0);
      EXPECT_EQ(shown.image.pixel(x, y)[3], 1);
    }
}

TEST(DifferencePicture, LinearFromZeroToTheMaximumGiven) {
  const DifferencePicture shown =
      differencePicture(powersOfTen(), kBlack, {}, {.colors = kBlackToGreen, .logarithmic = false, .max = 0.5});
  EXPECT_EQ(shown.image.pixel(0, 2)[1], 1);  // beyond the top
  EXPECT_NEAR(shown.image.pixel(1, 2)[1], 0.2, kStep);
  EXPECT_NEAR(shown.image.pixel(2, 2)[1], 0.02, kStep);
}

TEST(DifferencePicture, OfOneChannel) {
  const DifferencePicture shown = differencePicture(
      powersOfTen(), kBlack, {}, {.colors = kBlackToGreen, .logarithmic = false, .channel = std::size_t{2}});
  EXPECT_EQ(shown.image.pixel(0, 2)[1], 1);
  EXPECT_EQ(shown.image.pixel(0, 1)[1], 0);
}

TEST(DifferencePicture, WithoutOpacity) {
  const DifferencePicture shown =
      differencePicture(powersOfTen(), kBlack, {}, {.colors = kBlackToGreen, .logarithmic = false, .channels = 3});
  EXPECT_EQ(shown.image.pixel(0, 2)[1], 1);
  EXPECT_EQ(shown.image.pixel(0, 3)[1], 0);
}

TEST(DifferencePicture, MaskedPixelsAreNeutralAndDoNotSetTheScale) {
  std::vector<unsigned char> mask(32);
  for (std::size_t y = 0; y < 4; ++y) mask[8 * y] = 1;
  const DifferencePicture shown = differencePicture(powersOfTen(), kBlack, mask, {.colors = kBlackToGreen});
  EXPECT_EQ(shown.scale.axis.high, 0.1f);
  for (std::size_t c = 0; c < 3; ++c) EXPECT_EQ(shown.image.pixel(0, 1)[c], 0.5f);
  EXPECT_EQ(shown.image.pixel(1, 1)[1], 1);
}

/// Small errors still spread over three decades.
TEST(DifferencePicture, LowEndFollowsSmallErrors) {
  const DifferencePicture shown = differencePicture(constantImage(8, 4, 1e-6), kBlack, {}, {.colors = kBlackToGreen});
  EXPECT_NEAR(shown.scale.axis.low, 1e-9, 1e-15);
}

TEST(DifferencePicture, OfEqualPicturesIsAllOfTheFirstColour) {
  const DifferencePicture shown = differencePicture(kBlack, kBlack, {}, {.colors = {{0, 0, 1}, {0, 1, 0}}});
  for (int x = 0; x < 8; ++x) EXPECT_EQ(shown.image.pixel(x, 3)[2], 1);
}

TEST(DifferencePicture, HasRoomForTheBar) {
  const Image small = differencePicture(powersOfTen(), kBlack, {}, {.colors = kBlackToGreen}).image;
  EXPECT_GE(small.height, 200);
  EXPECT_EQ(small.pixel(3, 100)[0], 1) << "white below the picture";
  const Image large = constantImage(300, 400, 0);
  EXPECT_EQ(differencePicture(large, large, {}, {.colors = kBlackToGreen}).image.height, 400);
}

TEST(DifferencePicture, SameForAnyNumberOfThreads) {
  const Image truth = test::noise(200, 100, 1), picture = test::disturbed(truth, 0.1, 2);
  const Image all = differencePicture(picture, truth, {}, {.colors = kBlackToGreen}).image;
  const ThreadLimit limit(1);
  EXPECT_EQ(differencePicture(picture, truth, {}, {.colors = kBlackToGreen}).image.rgba, all.rgba);
}

TEST(DifferencePicture, RefusesWhatCannotBeShown) {
  EXPECT_THROW(differencePicture(kBlack, constantImage(4, 8, 0), {}, {.colors = kBlackToGreen}), Error);
  EXPECT_THROW(differencePicture(kBlack, kBlack, std::vector<unsigned char>(3), {.colors = kBlackToGreen}), Error);
  EXPECT_THROW(differencePicture(kBlack, kBlack, {}, {}), Error);
  EXPECT_THROW(differencePicture(kBlack, kBlack, {}, {.colors = kBlackToGreen, .max = 0.0}), Error);
  EXPECT_THROW(differencePicture(kBlack, kBlack, {}, {.colors = kBlackToGreen, .channel = std::size_t{4}}), Error);
}

}  // namespace
}  // namespace havs
