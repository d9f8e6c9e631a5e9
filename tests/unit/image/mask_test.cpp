#include "image/mask.h"

#include <gmock/gmock.h>

#include "image/image.h"
#include "support/temporary_folder.h"

namespace havs {
namespace {

TEST(Mask, ComesBack) {
  const test::TemporaryFolder folder;
  writeMask(std::vector<unsigned char>{0, 1, 0, 0, 7, 1}, 3, 2, folder / "a.png");
  int width = 0, height = 0;
  EXPECT_THAT(readMask(folder / "a.png", width, height), testing::ElementsAre(0, 1, 0, 0, 1, 1));
  EXPECT_EQ(width, 3);
  EXPECT_EQ(height, 2);
}

TEST(Mask, IsRedAboveOneHalf) {
  const test::TemporaryFolder folder;
  writeImage(Image{3, 1, {0.5f, 1, 1, 1, 0.51f, 0, 0, 1, 0, 1, 1, 1}}, folder / "a.exr");
  int width = 0, height = 0;
  EXPECT_THAT(readMask(folder / "a.exr", width, height), testing::ElementsAre(0, 1, 0));
}

}  // namespace
}  // namespace havs
