// The PNG files, read back by libpng: each number is the rounded one, whatever the size, and the file does not depend
// on the number of threads.
#include <gmock/gmock.h>

#include <cmath>
#include <limits>
#include <random>

#include "core/parallel.h"
#include "image/background.h"
#include "image/image.h"
#include "support/temporary_folder.h"

namespace havs {
namespace {

/// Opaque, so that reading gives back the numbers themselves; some outside [0, 1] and some that are none.
Image opaqueImage(int width, int height) {
  Image image{width, height, {}};
  std::mt19937 random(11);
  std::uniform_real_distribution<float> real(-0.1f, 1.1f);
  const std::size_t pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  for (std::size_t i = 0; i < pixels; ++i)
    image.rgba.insert(image.rgba.end(), {real(random), real(random), real(random), 1.0f});
  image.rgba[0] = std::numeric_limits<float>::quiet_NaN();
  return image;
}

double rounded(float value, double most) {
  return value > 0 ? static_cast<double>(std::lround(most * std::min(1.0, static_cast<double>(value)))) / most : 0;
}

TEST(PngWriter, EveryNumberIsTheRoundedOne) {
  const test::TemporaryFolder folder;
  for (const auto& [width, height] : {std::pair(1, 1), std::pair(3, 100), std::pair(131, 67)}) {
    const Image image = opaqueImage(width, height);
    for (const int bits : {8, 16})
      for (const auto& background : {std::optional<Color>(Color{1, 1, 1}), std::optional<Color>()}) {
        writeImage(image, folder / "a.png", {background, bits});
        const StoredImage read = readStoredImage(folder / "a.png");
        EXPECT_EQ(read.bits, bits);
        EXPECT_EQ(read.content, background ? ImageContent::rgb : ImageContent::rgba);
        ASSERT_EQ(read.image.width, width);
        ASSERT_EQ(read.image.height, height);
        for (std::size_t i = 0; i < image.rgba.size(); ++i)
          ASSERT_EQ(read.image.rgba[i], static_cast<float>(rounded(image.rgba[i], bits == 16 ? 65535 : 255))) << i;
      }
  }
}

TEST(PngWriter, ThreadsChangeNoByte) {
  const test::TemporaryFolder folder;
  const Image image = opaqueImage(64, 301);
  std::string first;
  for (const std::size_t threads : {1, 2, 3, 8}) {
    const ThreadLimit limit(threads);
    writeImage(image, folder / "a.png");
    const std::string content = test::contentOf(folder / "a.png");
    if (first.empty()) first = content;
    EXPECT_EQ(content, first) << threads;
  }
}

}  // namespace
}  // namespace havs
