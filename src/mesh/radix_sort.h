#pragma once
#include <bit>
#include <cstdint>
#include <vector>

#include "mesh/tet_mesh.h"

namespace havs {

/// Something to be sorted: its number and its key.
struct KeyedIndex {
  std::uint32_t key;
  Index index;
};

/// The bits of a float as an integer that orders as the floats do (-0 before +0; no NaN).
/// Herf 2001, "Radix tricks".
inline std::uint32_t sortableKey(float value) {
  const auto bits = std::bit_cast<std::uint32_t>(value);
  return bits ^ ((bits >> 31) != 0 ? 0xFFFFFFFFu : 0x80000000u);
}

/// Stable parallel radix sort by key, lowest digit first, three digits of 11 bits. Keeps its memory between calls.
class RadixSorter {
 public:
  /// Sorts `items` (which is left in another order) and writes the indices, lowest key first, into `sorted`.
  void sort(std::vector<KeyedIndex>& items, std::vector<Index>& sorted);

 private:
  std::vector<KeyedIndex> scratch_;
  std::vector<std::uint32_t> histograms_;
};

}  // namespace havs
