#include <gmock/gmock.h>

#include "image/image.h"
#include "support/temporary_folder.h"

namespace havs {
namespace {

const Image kHalf{1, 1, {0.25f, 0.25f, 0.25f, 0.5f}};

StoredImage throughFile(const std::string& name, const ImageFileOptions& options = {}) {
  const test::TemporaryFolder folder;
  writeImage(kHalf, folder / name, options);
  return readStoredImage(folder / name);
}

TEST(StoredImage, PngKnowsItsDepthAndOpacity) {
  const StoredImage over = throughFile("a.png");
  EXPECT_EQ(over.content, ImageContent::rgb);
  EXPECT_EQ(over.bits, 8);
  EXPECT_FALSE(over.floats);
  const StoredImage clear = throughFile("a.png", {std::nullopt, 16});
  EXPECT_EQ(clear.content, ImageContent::rgba);
  EXPECT_EQ(clear.bits, 16);
  EXPECT_FALSE(clear.floats);
}

TEST(StoredImage, ExrHoldsOpacityAndPfmDoesNot) {
  const StoredImage exr = throughFile("a.exr"), pfm = throughFile("a.pfm");
  EXPECT_EQ(exr.content, ImageContent::rgba);
  EXPECT_EQ(pfm.content, ImageContent::rgb);
  for (const StoredImage* stored : {&exr, &pfm}) {
    EXPECT_EQ(stored->bits, 32);
    EXPECT_TRUE(stored->floats);
  }
}

}  // namespace
}  // namespace havs
