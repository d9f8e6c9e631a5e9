// How the a-buffer cuts a picture by the number of its fragments; no OpenGL in this.
#include "render/gl/abuffer_tiles.h"

#include <gtest/gtest.h>

#include <numeric>
#include <random>

#include "core/error.h"

namespace havs::test {
namespace {

/// Every pixel with fragments is in one tile, no tile holds more than `most`, and each says truly what it holds.
void expectPartition(const std::vector<std::uint32_t>& counts, int width, std::size_t most) {
  const std::vector<FragmentTile> tiles = cutByFragments(counts, width, most);
  std::vector<int> seen(counts.size());
  for (const FragmentTile& tile : tiles) {
    std::size_t sum = 0;
    for (int y = tile.area.y; y < tile.area.y + tile.area.height; ++y)
      for (int x = tile.area.x; x < tile.area.x + tile.area.width; ++x) {
        const auto i = static_cast<std::size_t>(y * width + x);
        ++seen[i];
        sum += counts[i];
      }
    EXPECT_EQ(sum, tile.fragments);
    EXPECT_LE(sum, most);
    EXPECT_GT(sum, 0u);
  }
  for (std::size_t i = 0; i < counts.size(); ++i) {
    EXPECT_LE(seen[i], 1);
    if (counts[i] > 0) {
      EXPECT_EQ(seen[i], 1) << "pixel " << i;
    }
  }
}

TEST(ABufferTiles, CoverEveryPixelWithFragmentsOnce) {
  std::mt19937 random(3);
  for (const int width : {1, 7, 40})
    for (const std::uint32_t greatest : {0u, 1u, 30u}) {
      std::vector<std::uint32_t> counts(static_cast<std::size_t>(width) * 23);
      for (auto& count : counts) count = random() % 3 == 0 ? random() % (greatest + 1) : 0;
      for (const std::size_t most : {std::size_t{30}, std::size_t{100}, std::size_t{1000}, std::size_t{1000000}})
        expectPartition(counts, width, most);
    }
}

TEST(ABufferTiles, AreAsFewAsRowsAllow) {
  const std::vector<std::uint32_t> counts(10 * 8, 1);  // eight rows of ten
  EXPECT_EQ(cutByFragments(counts, 10, 80).size(), 1u);
  EXPECT_EQ(cutByFragments(counts, 10, 79).size(), 2u);  // seven rows and one
  EXPECT_EQ(cutByFragments(counts, 10, 20).size(), 4u);
  EXPECT_EQ(cutByFragments(counts, 10, 5).size(), 16u);  // halves of rows
  EXPECT_TRUE(cutByFragments(std::vector<std::uint32_t>(80), 10, 5).empty());
}

TEST(ABufferTiles, RefuseAPixelThatDoesNotFit) {
  const std::vector<std::uint32_t> counts{1, 2, 9, 1};
  EXPECT_EQ(cutByFragments(counts, 2, 9).size(), 3u);
  EXPECT_THROW(cutByFragments(counts, 2, 8), Error);
}

TEST(ABufferTiles, ListsLieOneAfterAnother) {
  const std::vector<std::uint32_t> counts{1, 2, 3, 4, 5, 6, 7, 8, 9};
  EXPECT_EQ(listBegins(counts, 3, {1, 1, 2, 2}), (std::vector<std::uint32_t>{0, 5, 11, 19, 28}));
}

}  // namespace
}  // namespace havs::test
