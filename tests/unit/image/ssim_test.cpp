#include "image/ssim.h"

#include <gmock/gmock.h>

#include <cmath>

#include "unit/image/pictures.h"

namespace havs {
namespace {

using test::constantImage;
using test::madeImage;

constexpr double kC1 = 1e-4, kC2 = 9e-4;

/// Weights of a window cut at the picture's border, by the definition: no separation into rows and columns.
double windowedSsim(const Image& a, const Image& b, int centreX, int centreY, int c) {
  double weights = 0, meanA = 0, meanB = 0;
  const auto eachPixel = [&](const auto& visit) {
    for (int y = std::max(0, centreY - 5); y <= std::min(a.height - 1, centreY + 5); ++y)
      for (int x = std::max(0, centreX - 5); x <= std::min(a.width - 1, centreX + 5); ++x) {
        const double squared = (x - centreX) * (x - centreX) + (y - centreY) * (y - centreY);
        visit(std::exp(-squared / (2 * 1.5 * 1.5)), double{a.pixel(x, y)[c]}, double{b.pixel(x, y)[c]});
      }
  };
  eachPixel([&](double w, double u, double v) {
    weights += w;
    meanA += w * u;
    meanB += w * v;
  });
  meanA /= weights;
  meanB /= weights;
  double varianceA = 0, varianceB = 0, covariance = 0;
  eachPixel([&](double w, double u, double v) {
    varianceA += w / weights * (u - meanA) * (u - meanA);
    varianceB += w / weights * (v - meanB) * (v - meanB);
    covariance += w / weights * (u - meanA) * (v - meanB);
  });
  return (2 * meanA * meanB + kC1) * (2 * covariance + kC2) /
         ((meanA * meanA + meanB * meanB + kC1) * (varianceA + varianceB + kC2));
}

double meanSsim(const Image& a, const Image& b, int c, const std::vector<unsigned char>& mask = {}) {
  const int marginX = a.width > 10 ? 5 : 0, marginY = a.height > 10 ? 5 : 0;
  double sum = 0;
  int windows = 0;
  for (int y = marginY; y < a.height - marginY; ++y)
    for (int x = marginX; x < a.width - marginX; ++x) {
      if (!mask.empty() && mask[static_cast<std::size_t>(y * a.width + x)]) continue;
      sum += windowedSsim(a, b, x, y, c);
      ++windows;
    }
  return sum / windows;
}

/// Moments about zero lose at most some 1e-16 of squares below 1, against C2 = 9e-4.
constexpr double kSsimRounding = 1e-12;

TEST(Ssim, EqualsTheDefinitionSummedDirectly) {
  for (const auto& [width, height] : {std::pair{37, 23}, {11, 11}, {12, 40}, {64, 7}, {3, 30}, {5, 4}, {1, 1}}) {
    const Image a = test::noise(width, height, 3), b = test::disturbed(a, 0.3, 4);
    const auto ssim = structuralSimilarity(a, b);
    for (int c = 0; c < 4; ++c)
      EXPECT_NEAR(ssim[static_cast<std::size_t>(c)], meanSsim(a, b, c), kSsimRounding) << width << "x" << height;
  }
}

TEST(Ssim, LeavesOutMaskedCentres) {
  const Image a = test::noise(30, 20, 3), b = test::disturbed(a, 0.3, 4);
  std::vector<unsigned char> mask(600);
  for (std::size_t i = 0; i < mask.size(); i += 3) mask[i] = 1;
  EXPECT_NEAR(structuralSimilarity(a, b, mask)[1], meanSsim(a, b, 1, mask), kSsimRounding);
}

TEST(Ssim, NoCentreLeftIsNotANumber) {
  const Image a = constantImage(11, 11, 0.5);
  std::vector<unsigned char> mask(121);
  mask[60] = 1;  // the only window's
  EXPECT_TRUE(std::isnan(structuralSimilarity(a, a, mask)[0]));
}

/// Constant pictures u and v: (2 u v + C1) / (u^2 + v^2 + C1).
TEST(Ssim, OfConstantPictures) {
  const double u = 0.75, v = 0.25;
  const double expected = (2 * u * v + kC1) / (u * u + v * v + kC1);
  for (const double ssim : structuralSimilarity(constantImage(20, 15, u), constantImage(20, 15, v)))
    EXPECT_NEAR(ssim, expected, kSsimRounding);
}

/// One bright pixel v under the only window against black: with w its weight, mean w v, variance w (1 - w) v^2.
TEST(Ssim, OfOneBrightPixel) {
  double sum = 0;
  for (int i = -5; i <= 5; ++i) sum += std::exp(-i * i / 4.5);
  const double v = 0.5;
  for (const auto& [x, y] : {std::pair{5, 5}, {6, 3}, {0, 10}}) {
    const double w = std::exp(-((x - 5) * (x - 5) + (y - 5) * (y - 5)) / 4.5) / (sum * sum);
    const double expected = kC1 * kC2 / ((w * v * w * v + kC1) * (w * (1 - w) * v * v + kC2));
    const Image bright =
        madeImage(11, 11, [x = x, y = y](int px, int py, int) { return px == x && py == y ? 0.5 : 0.0; });
    EXPECT_NEAR(structuralSimilarity(bright, constantImage(11, 11, 0))[2], expected, kSsimRounding);
  }
}

TEST(Ssim, OfEqualPicturesIsExactlyOne) {
  const Image a = test::noise(50, 40, 9);
  EXPECT_THAT(structuralSimilarity(a, a), testing::Each(1.0));
}

/// Pictures in 64ths, exact in float, and what scikit-image 0.19.3 gives for each channel:
/// structural_similarity(a, b, gaussian_weights=True, sigma=1.5, use_sample_covariance=False, data_range=1).
TEST(Ssim, IsThatOfScikitImage) {
  const auto wave = [](int x, int y, int c) { return 7 * x + 11 * y + 5 * c + x * y / 8; };
  const Image a = madeImage(40, 30, [&](int x, int y, int c) { return wave(x, y, c) % 64 / 64.0; });
  const Image b =
      madeImage(40, 30, [&](int x, int y, int c) { return (wave(x, y, c) + (3 * x + y + c) % 5) % 64 / 64.0; });
  const auto ssim = structuralSimilarity(a, b);
  EXPECT_NEAR(ssim[0], 0.8475247968438556, kSsimRounding);
  EXPECT_NEAR(ssim[1], 0.7977588657849869, kSsimRounding);
  EXPECT_NEAR(ssim[2], 0.8586742088791840, kSsimRounding);
  EXPECT_NEAR(ssim[3], 0.8588794163119646, kSsimRounding);
}

}  // namespace
}  // namespace havs
