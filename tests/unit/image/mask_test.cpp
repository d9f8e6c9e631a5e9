#include "image/mask.h"

#include <gtest/gtest.h>

#include "core/error.h"
#include "image/image.h"
#include "support/temporary_folder.h"

namespace havs::test {
namespace {

TEST(Mask, ComesBackAsItWasWritten) {
  const TemporaryFolder folder;
  const std::vector<unsigned char> mask{1, 0, 0, 7, 0, 1};  // anything but 0 is marked
  writeMask(mask, 3, 2, folder / "m.png");
  int width = 0, height = 0;
  EXPECT_EQ(readMask(folder / "m.png", width, height), (std::vector<unsigned char>{1, 0, 0, 1, 0, 1}));
  EXPECT_EQ(width, 3);
  EXPECT_EQ(height, 2);
  const Image image = readImage(folder / "m.png");
  for (int c = 0; c < 4; ++c) EXPECT_EQ(image.pixel(0, 0)[c], 1.0f);  // white
  for (int c = 0; c < 3; ++c) EXPECT_EQ(image.pixel(1, 0)[c], 0.0f);  // black
}

TEST(Mask, IsMarkedWhereRedIsMoreThanHalf) {
  const TemporaryFolder folder;
  Image image{3, 1, {0.5f, 1, 1, 1, 0.51f, 0, 0, 1, 0.9f, 0.9f, 0.9f, 0}};
  writeImage(image, folder / "m.exr");
  int width = 0, height = 0;
  EXPECT_EQ(readMask(folder / "m.exr", width, height), (std::vector<unsigned char>{0, 1, 1}));
}

TEST(Mask, RefusesNamesAndFilesThatItCannotUse) {
  const TemporaryFolder folder;
  const std::vector<unsigned char> mask{1};
  int width = 0, height = 0;
  EXPECT_THROW(checkMaskPath(folder / "m.exr"), Error);
  EXPECT_THROW(checkMaskPath(folder / "none/m.png"), Error);
  EXPECT_THROW(writeMask(mask, 1, 1, folder / "m.pfm"), Error);
  EXPECT_THROW(writeMask(mask, 0, 0, folder / "m.png"), Error);
  EXPECT_THROW(readMask(folder / "m.png", width, height), Error);
  EXPECT_EQ(folder.entries(), 0u);
}

}  // namespace
}  // namespace havs::test
