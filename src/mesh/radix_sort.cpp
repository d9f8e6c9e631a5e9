// Parallel LSD radix sort: the input is cut into blocks; for each digit every block counts its digits, a running sum
// over (digit, block) gives each block the place of its first item of each digit, and the blocks move their items
// there. Stable, so the result does not depend on how the input was cut.
#include "mesh/radix_sort.h"

#include <algorithm>

#include "core/parallel.h"

namespace havs {
namespace {

constexpr unsigned kDigitBits = 11;
constexpr unsigned kDigits = 3;
constexpr std::size_t kRadix = std::size_t{1} << kDigitBits;
constexpr std::size_t kBlock = std::size_t{1} << 16;  // many times kRadix, so that counting is cheap beside moving

std::size_t digitOf(std::uint32_t key, unsigned digit) { return (key >> (digit * kDigitBits)) & (kRadix - 1); }

/// One pass: moves source[i] to its place for this digit by calling place(position, item).
template <class Place>
void distribute(const std::vector<KeyedIndex>& source, unsigned digit, std::vector<std::uint32_t>& histograms,
                const Place& place) {
  const std::size_t blocks = (source.size() + kBlock - 1) / kBlock;
  histograms.assign(blocks * kRadix, 0);
  auto forEachItem = [&](std::size_t block, const auto& visit) {
    const std::size_t end = std::min(source.size(), (block + 1) * kBlock);
    for (std::size_t i = block * kBlock; i < end; ++i) visit(source[i]);
  };
  parallelFor(0, blocks, 1, [&](std::size_t block) {
    std::uint32_t* counts = histograms.data() + block * kRadix;
    forEachItem(block, [&](const KeyedIndex& item) { ++counts[digitOf(item.key, digit)]; });
  });
  std::uint32_t begin = 0;
  for (std::size_t d = 0; d < kRadix; ++d)
    for (std::size_t block = 0; block < blocks; ++block) {
      const std::uint32_t count = histograms[block * kRadix + d];
      histograms[block * kRadix + d] = begin;
      begin += count;
    }
  parallelFor(0, blocks, 1, [&](std::size_t block) {
    std::uint32_t* next = histograms.data() + block * kRadix;
    forEachItem(block, [&](const KeyedIndex& item) { place(next[digitOf(item.key, digit)]++, item); });
  });
}

}  // namespace

void RadixSorter::sort(std::vector<KeyedIndex>& items, std::vector<Index>& sorted) {
  scratch_.resize(items.size());
  sorted.resize(items.size());
  static_assert(kDigits == 3 && kDigits * kDigitBits >= 32);
  distribute(items, 0, histograms_, [&](std::size_t to, const KeyedIndex& item) { scratch_[to] = item; });
  distribute(scratch_, 1, histograms_, [&](std::size_t to, const KeyedIndex& item) { items[to] = item; });
  distribute(items, 2, histograms_, [&](std::size_t to, const KeyedIndex& item) { sorted[to] = item.index; });
}

}  // namespace havs
