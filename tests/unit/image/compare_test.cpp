#include "image/compare.h"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>

#include "core/error.h"
#include "core/parallel.h"
#include "unit/image/pictures.h"

namespace havs {
namespace {

using test::constantImage;
using test::madeImage;

constexpr double kRounding = 1e-15;  // of a few operations in double on numbers below 1

/// 40 x 50 pixels, one of which is off by 1/2 in green, ten by 1/4 in opacity.
Image withErrors(Image image) {
  image.pixel(7, 3)[1] += 0.5f;
  for (int x = 0; x < 10; ++x) image.pixel(x, 20)[3] -= 0.25f;
  return image;
}

TEST(CompareImages, MeasuresWhatWasPutIn) {
  const Image truth = constantImage(40, 50, 0.5);
  const Comparison comparison = compareImages(withErrors(truth), truth);
  EXPECT_EQ(comparison.pixels, 2000u);
  EXPECT_EQ(comparison.masked, 0u);
  EXPECT_EQ(comparison.channels[0].rmse, 0);
  EXPECT_NEAR(comparison.channels[1].rmse, std::sqrt(0.25 / 2000), kRounding);
  EXPECT_NEAR(comparison.channels[3].rmse, std::sqrt(10 * 0.0625 / 2000), kRounding);
  EXPECT_NEAR(comparison.rgba.rmse, std::sqrt((0.25 + 0.625) / 8000), kRounding);
  EXPECT_NEAR(comparison.rgba.psnr, 10 * std::log10(8000 / 0.875), 1e-12);
  EXPECT_EQ(comparison.rgba.max, 0.5);
  EXPECT_EQ(comparison.channels[3].max, 0.25);
  EXPECT_EQ(comparison.worstX, 7);
  EXPECT_EQ(comparison.worstY, 3);
  EXPECT_EQ(comparison.worstChannel, 1u);
}

/// Nearest rank: of 2000 pixels 1998 stay at or below it. Eleven are off, so that the 1998th is off by 1/4.
TEST(CompareImages, PercentileIsThatOfTheNearestRank) {
  const Image truth = constantImage(40, 50, 0.5);
  const Comparison comparison = compareImages(withErrors(truth), truth);
  EXPECT_EQ(comparison.rgba.p999, 0.25);
  EXPECT_EQ(comparison.channels[1].p999, 0);  // one pixel in 2000 is no 0.1%
  EXPECT_EQ(comparison.channels[3].p999, 0.25);
}

TEST(CompareImages, PercentileOfEveryCount) {
  for (const int pixels : {1, 2, 999, 1000, 1001, 1999, 2000, 2001}) {
    const Image truth = constantImage(pixels, 1, 0);
    const Image picture = madeImage(pixels, 1, [](int x, int, int c) { return c == 0 ? x : 0; });
    const int rank = static_cast<int>(std::ceil(999 * pixels / 1000.0));  // exact: the quotient has few digits
    EXPECT_EQ(compareImages(picture, truth).channels[0].p999, rank - 1) << pixels;
  }
}

TEST(CompareImages, ChannelsTogetherTakeTheWorstOfEachPixel) {
  const Image truth = constantImage(3, 1, 0);
  const Image picture = madeImage(3, 1, [](int x, int, int c) { return x == c ? -0.25 * (c + 1) : 0; });
  const Comparison comparison = compareImages(picture, truth);
  EXPECT_EQ(comparison.rgba.max, 0.75);
  EXPECT_EQ(comparison.worstX, 2);
  EXPECT_EQ(comparison.worstChannel, 2u);
}

TEST(CompareImages, EqualPictures) {
  const Image image = test::noise(33, 21, 5);
  const Comparison comparison = compareImages(image, image);
  EXPECT_EQ(comparison.rgba.rmse, 0);
  EXPECT_EQ(comparison.rgba.p999, 0);
  EXPECT_EQ(comparison.rgba.max, 0);
  EXPECT_EQ(comparison.rgba.psnr, std::numeric_limits<double>::infinity());
  EXPECT_EQ(comparison.rgba.ssim, 1);
}

/// scikit-image 0.19.3 on the pictures of ssim_test.cpp: square root of mean_squared_error, and
/// peak_signal_noise_ratio with data_range 1.
TEST(CompareImages, IsWhatScikitImageMeasures) {
  const auto wave = [](int x, int y, int c) { return 7 * x + 11 * y + 5 * c + x * y / 8; };
  const Image truth = madeImage(40, 30, [&](int x, int y, int c) { return wave(x, y, c) % 64 / 64.0; });
  const Image picture =
      madeImage(40, 30, [&](int x, int y, int c) { return (wave(x, y, c) + (3 * x + y + c) % 5) % 64 / 64.0; });
  const ErrorMeasures measures = compareImages(picture, truth).rgba;
  EXPECT_NEAR(measures.rmse, 0.17083968484127646, kRounding);
  EXPECT_NEAR(measures.psnr, 15.348224768297014, 1e-12);
  EXPECT_NEAR(measures.ssim, 0.8407093219549977, 1e-12);
  EXPECT_EQ(measures.p999, 0.984375);
}

TEST(CompareImages, MaskLeavesPixelsOut) {
  const Image truth = constantImage(40, 50, 0.5);
  const Image picture = withErrors(truth);
  std::vector<unsigned char> mask(2000);
  mask[3 * 40 + 7] = 1;
  const Comparison comparison = compareImages(picture, truth, mask);
  EXPECT_EQ(comparison.pixels, 1999u);
  EXPECT_EQ(comparison.masked, 1u);
  EXPECT_EQ(comparison.rgba.max, 0.25);
  EXPECT_EQ(comparison.worstY, 20);
  EXPECT_EQ(comparison.channels[1].rmse, 0);
  EXPECT_EQ(comparison.channels[1].ssim, 1) << "the masked value must not reach its neighbours' windows";
  EXPECT_NEAR(comparison.channels[3].rmse, std::sqrt(0.625 / 1999), kRounding);
}

TEST(CompareImages, OfRgbLeavesOpacityOut) {
  const Image truth = constantImage(40, 50, 0.5);
  const Comparison comparison = compareImages(withErrors(truth), truth, {}, ImageContent::rgb);
  EXPECT_EQ(comparison.channelCount, 3u);
  EXPECT_NEAR(comparison.rgba.rmse, std::sqrt(0.25 / 6000), kRounding);
  EXPECT_NEAR(comparison.rgba.ssim, (2 + comparison.channels[1].ssim) / 3, kRounding);
}

void expectSame(const ErrorMeasures& a, const ErrorMeasures& b) {
  EXPECT_EQ(a.rmse, b.rmse);
  EXPECT_EQ(a.p999, b.p999);
  EXPECT_EQ(a.max, b.max);
  EXPECT_EQ(a.ssim, b.ssim);
}

TEST(CompareImages, SameForAnyNumberOfThreads) {
  const Image truth = test::noise(251, 130, 1), picture = test::disturbed(truth, 0.1, 2);
  std::vector<unsigned char> mask(truth.rgba.size() / 4);
  for (std::size_t i = 0; i < mask.size(); i += 7) mask[i] = 1;
  const Comparison all = compareImages(picture, truth, mask);
  for (const std::size_t threads : {1u, 2u, 3u, 7u}) {
    const ThreadLimit limit(threads);
    const Comparison comparison = compareImages(picture, truth, mask);
    expectSame(comparison.rgba, all.rgba);
    for (std::size_t c = 0; c < 4; ++c) expectSame(comparison.channels[c], all.channels[c]);
    EXPECT_EQ(comparison.worstX, all.worstX);
    EXPECT_EQ(comparison.worstY, all.worstY);
  }
}

std::string refusal(const Image& picture, const Image& truth, const std::vector<unsigned char>& mask = {}) {
  try {
    compareImages(picture, truth, mask);
  } catch (const Error& error) {
    EXPECT_EQ(error.exitStatus(), 2);
    return error.what();
  }
  return "nothing was thrown";
}

TEST(CompareImages, RefusesWhatCannotBeCompared) {
  const Image image = constantImage(4, 3, 0.5);
  EXPECT_THAT(refusal(image, constantImage(3, 4, 0.5)), testing::HasSubstr("4 x 3 against 3 x 4"));
  EXPECT_THAT(refusal(Image{}, Image{}), testing::HasSubstr("without pixels"));
  EXPECT_THAT(refusal(image, image, std::vector<unsigned char>(11)), testing::HasSubstr("11 pixels"));
  EXPECT_THAT(refusal(image, image, std::vector<unsigned char>(12, 1)), testing::HasSubstr("leaves no pixel"));
  Image bad = image;
  bad.pixel(3, 1)[2] = std::numeric_limits<float>::quiet_NaN();
  EXPECT_THAT(refusal(bad, image), testing::HasSubstr("picture: pixel 3,1 has the value nan in blue"));
  bad.pixel(3, 1)[2] = std::numeric_limits<float>::infinity();
  EXPECT_THAT(refusal(image, bad), testing::HasSubstr("truth: pixel 3,1 has the value inf in blue"));
}

/// Squares of the greatest floats, and their products in SSIM, stay finite in double.
TEST(CompareImages, TakesEveryFiniteFloat) {
  const float most = std::numeric_limits<float>::max();
  const Image a = constantImage(20, 20, most), b = constantImage(20, 20, -double{most});
  const ErrorMeasures measures = compareImages(a, b).rgba;
  EXPECT_EQ(measures.max, 2 * double{most});
  EXPECT_NEAR(measures.rmse / measures.max, 1, 1e-12);
  EXPECT_NEAR(measures.ssim, -1, 1e-12);
}

}  // namespace
}  // namespace havs
