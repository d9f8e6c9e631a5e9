#include <gmock/gmock.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <random>

#include "core/error.h"
#include "image/image.h"
#include "support/temporary_folder.h"

namespace havs {
namespace {

Image randomImage(int width, int height) {
  Image image{width, height,
              std::vector<float>(4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height))};
  std::mt19937 generator(7);
  std::uniform_real_distribution<float> uniform(0, 1);
  for (std::size_t i = 0; i < image.rgba.size(); i += 4) {
    const float alpha = i % 12 == 0 ? 0.0f : uniform(generator);
    for (std::size_t c = 0; c < 3; ++c) image.rgba[i + c] = alpha * uniform(generator);
    image.rgba[i + 3] = alpha;
  }
  return image;
}

class ImageFile : public testing::Test {
 protected:
  test::TemporaryFolder folder;
};

TEST_F(ImageFile, ExrGivesBackEveryBit) {
  Image image = randomImage(37, 21);
  image.rgba[5] = -0.25f;
  image.rgba[6] = 1e30f;
  writeImage(image, folder / "a.exr");
  const Image read = readImage(folder / "a.exr");
  EXPECT_EQ(read.width, 37);
  EXPECT_EQ(read.height, 21);
  EXPECT_EQ(std::memcmp(read.rgba.data(), image.rgba.data(), image.rgba.size() * sizeof(float)), 0);
}

TEST_F(ImageFile, PfmGivesBackEveryBitOverBlack) {
  const Image image = randomImage(5, 9);
  writeImage(image, folder / "a.pfm", {std::nullopt, 8});
  const Image read = readImage(folder / "a.pfm");
  for (std::size_t i = 0; i < image.rgba.size(); ++i) EXPECT_EQ(read.rgba[i], i % 4 == 3 ? 1.0f : image.rgba[i]);
}

TEST_F(ImageFile, PfmHoldsTheBottomRowFirstInLittleEndian) {
  Image image{1, 2, {1, 2, 3, 1, 4, 5, 6, 1}};
  writeImage(image, folder / "a.pfm");
  const std::string content = test::contentOf(folder / "a.pfm");
  ASSERT_EQ(content.substr(0, 12), "PF\n1 2\n-1.0\n");
  std::array<float, 6> numbers;
  ASSERT_EQ(content.size(), 12 + sizeof numbers);
  std::memcpy(numbers.data(), content.data() + 12, sizeof numbers);
  EXPECT_THAT(numbers, testing::ElementsAre(4, 5, 6, 1, 2, 3));
}

TEST_F(ImageFile, PfmReadsBigEndianToo) {
  folder.write("a.pfm", std::string("PF\n1 1\n1.0\n") + std::string("\x3f\x80\0\0\x40\0\0\0\0\0\0\0", 12));
  EXPECT_THAT(readImage(folder / "a.pfm").rgba, testing::ElementsAre(1, 2, 0, 1));
}

/// Every value that PNG can hold comes back as itself: its number over the greatest one.
TEST_F(ImageFile, PngHoldsEveryStepOfBothDepths) {
  for (const int bits : {8, 16}) {
    const int steps = 1 << bits;
    Image image{steps / 4, 4, std::vector<float>(4 * static_cast<std::size_t>(steps), 1.0f)};
    for (int i = 0; i < steps; ++i) image.rgba[4 * static_cast<std::size_t>(i)] = static_cast<float>(i / (steps - 1.0));
    writeImage(image, folder / "a.png", {Color{1, 1, 1}, bits});
    EXPECT_EQ(readImage(folder / "a.png").rgba, image.rgba) << bits;
  }
}

TEST_F(ImageFile, PngRoundsToTheNearestStepAndClamps) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  Image image{2, 1, {0.499f / 255, 0.501f / 255, 1.5f, 1, -3, nan, 1, 1}};
  writeImage(image, folder / "a.png");
  EXPECT_THAT(readImage(folder / "a.png").rgba, testing::ElementsAre(0, 1.0f / 255, 1, 1, 0, 0, 1, 1));
}

TEST_F(ImageFile, PngBlendsOverTheBackground) {
  Image image{2, 1, {0.2f, 0, 0, 0.2f, 0, 0, 0, 0}};
  writeImage(image, folder / "a.png", {Color{1, 0.5, 0}, 16});
  const Image read = readImage(folder / "a.png");
  constexpr float kHalfStep = 0.5f / 65535 + 1e-7f;  // of 16 bits, and float's rounding
  const float expected[8] = {1, 0.4f, 0, 1, 1, 0.5f, 0, 1};
  for (std::size_t i = 0; i < 8; ++i) EXPECT_NEAR(read.rgba[i], expected[i], kHalfStep) << i;
}

TEST_F(ImageFile, PngWithoutBackgroundHoldsStraightAlpha) {
  const Image image = randomImage(16, 16);
  writeImage(image, folder / "a.png", {std::nullopt, 16});
  const Image read = readImage(folder / "a.png");
  // Straight colour is off by half a step, times alpha; alpha by half a step, times colour: together at most one step.
  constexpr float kStep = 1.0f / 65535 + 1e-7f;
  for (std::size_t i = 0; i < image.rgba.size(); ++i) EXPECT_NEAR(read.rgba[i], image.rgba[i], kStep) << i;
}

TEST_F(ImageFile, LargeRowsPassThrough) {
  Image image{70000, 2, std::vector<float>(4 * 2 * 70000, 1.0f)};  // beyond 16 bits, and libpng's limit aside
  image.pixel(69999, 1)[1] = 0;
  for (const char* name : {"a.png", "a.exr", "a.pfm"}) {
    writeImage(image, folder / name);
    EXPECT_EQ(readImage(folder / name).rgba, image.rgba) << name;
  }
}

TEST_F(ImageFile, ReplacesAnOlderFileAndLeavesNothingBeside) {
  folder.write("a.png", "older");
  writeImage(randomImage(2, 2), folder / "a.png");
  EXPECT_EQ(readImage(folder / "a.png").width, 2);
  EXPECT_EQ(folder.entries(), 1u);
}

TEST_F(ImageFile, CapitalExtensionsCount) {
  writeImage(randomImage(2, 2), folder / "A.PNG");
  EXPECT_EQ(readImage(folder / "A.PNG").height, 2);
}

}  // namespace
}  // namespace havs
