#include "mesh/radix_sort.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>

#include "core/parallel.h"

namespace havs {
namespace {

TEST(RadixSort, AgreesWithAStableComparisonSort) {
  std::mt19937 random(7);
  RadixSorter sorter;
  // Sizes around one block and several; keys with many ties and with all 32 bits.
  for (const std::size_t size : {0u, 1u, 2u, 1000u, 65536u, 65537u, 300000u})
    for (const std::uint32_t mask : {0x3u, 0xFFu << 20, 0xFFFFFFFFu}) {
      std::vector<KeyedIndex> items(size);
      for (std::size_t i = 0; i < size; ++i)
        items[i] = {static_cast<std::uint32_t>(random()) & mask, static_cast<Index>(i)};
      std::vector<KeyedIndex> expected = items;
      std::stable_sort(expected.begin(), expected.end(),
                       [](const KeyedIndex& a, const KeyedIndex& b) { return a.key < b.key; });
      std::vector<Index> sorted;
      sorter.sort(items, sorted);
      ASSERT_EQ(sorted.size(), size);
      EXPECT_TRUE(std::equal(sorted.begin(), sorted.end(), expected.begin(),
                             [](Index index, const KeyedIndex& item) { return index == item.index; }));
    }
}

TEST(RadixSort, KeysOrderAsTheFloatsDo) {
  constexpr float kLargest = std::numeric_limits<float>::max(), kInfinity = std::numeric_limits<float>::infinity();
  const std::vector<float> ascending{-kInfinity, -kLargest, -1.5f, -1e-30f,  -1e-45f,  0.0f,
                                     1e-45f,     1e-30f,    1.5f,  kLargest, kInfinity};
  for (std::size_t i = 1; i < ascending.size(); ++i)
    EXPECT_LT(sortableKey(ascending[i - 1]), sortableKey(ascending[i])) << ascending[i];
}

}  // namespace
}  // namespace havs
