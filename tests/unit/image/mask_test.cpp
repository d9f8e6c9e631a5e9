#include "image/mask.h"

#include <gmock/gmock.h>

#include "core/error.h"
#include "image/image.h"
#include "support/temporary_folder.h"

namespace havs {
namespace {

TEST(Mask, ComesBackFromEveryFormat) {
  const test::TemporaryFolder folder;
  const std::vector<unsigned char> mask{0, 1, 0, 0, 7, 1};
  for (const char* name : {"a.png", "a.exr", "a.pfm"}) {
    writeMask(mask, 3, 2, folder / name);
    int width = 0, height = 0;
    EXPECT_THAT(readMask(folder / name, width, height), testing::ElementsAre(0, 1, 0, 0, 1, 1)) << name;
    EXPECT_EQ(width, 3);
    EXPECT_EQ(height, 2);
  }
}

TEST(Mask, IsRedAboveOneHalf) {
  const test::TemporaryFolder folder;
  writeImage(Image{3, 1, {0.5f, 1, 1, 1, 0.51f, 0, 0, 1, 0, 1, 1, 1}}, folder / "a.exr");
  int width = 0, height = 0;
  EXPECT_THAT(readMask(folder / "a.exr", width, height), testing::ElementsAre(0, 1, 0));
}

TEST(Mask, RefusesAnotherSize) {
  const test::TemporaryFolder folder;
  EXPECT_THROW(writeMask(std::vector<unsigned char>(5), 3, 2, folder / "a.png"), Error);
  EXPECT_EQ(folder.entries(), 0u);
}

}  // namespace
}  // namespace havs
