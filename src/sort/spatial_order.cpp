#include "sort/spatial_order.h"

#include <algorithm>
#include <cstdint>

#include "core/parallel.h"
#include "sort/radix_sort.h"

namespace havs {
namespace {

/// Puts two zero bits before each of the ten low bits.
std::uint32_t spread(std::uint32_t x) {
  x = (x | (x << 16)) & 0x030000FFu;
  x = (x | (x << 8)) & 0x0300F00Fu;
  x = (x | (x << 4)) & 0x030C30C3u;
  x = (x | (x << 2)) & 0x09249249u;
  return x;
}

std::uint32_t mortonCode(const Vec3& p) {
  auto quantised = [](double x) { return static_cast<std::uint32_t>(std::clamp((x + 1) * 512, 0.0, 1023.0)); };
  return spread(quantised(p.x)) | (spread(quantised(p.y)) << 1) | (spread(quantised(p.z)) << 2);
}

}  // namespace

std::vector<Index> spatialOrder(std::span<const Vec3> points, std::span<const Tetrahedron> tetrahedra) {
  std::vector<KeyedIndex> items(tetrahedra.size());
  parallelFor(0, items.size(), 8192, [&](std::size_t c) {
    const auto& [i, j, k, l] = tetrahedra[c];
    items[c] = {mortonCode((points[i] + points[j] + points[k] + points[l]) / 4.0), static_cast<Index>(c)};
  });
  std::vector<Index> order;
  RadixSorter().sort(items, order);
  return order;
}

}  // namespace havs
