#include "light/point_cells.h"

#include <algorithm>
#include <atomic>
#include <utility>

#include "core/parallel.h"

namespace havs {
namespace {}

PointCells::PointCells(std::size_t points, std::span<const Tetrahedron> cells) : first_(points + 1, 0) {
  const auto atomically = [](std::size_t& count) { return std::atomic_ref(count); };
  parallelFor(0, cells.size(), kGrain, [&](std::size_t c) {
    for (const Index v : cells[c]) atomically(first_[v]).fetch_add(1, std::memory_order_relaxed);
  });
  std::size_t before = 0;
  for (std::size_t& entry : first_) before += std::exchange(entry, before);
  cells_.resize(before);
  // Each point's range is filled in any order, then sorted.
  std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
  parallelFor(0, cells.size(), kGrain, [&](std::size_t c) {
    for (const Index v : cells[c])
      cells_[atomically(next[v]).fetch_add(1, std::memory_order_relaxed)] = static_cast<Index>(c);
  });
  parallelFor(0, points, kGrain, [&](std::size_t p) {
    std::sort(cells_.begin() + static_cast<std::ptrdiff_t>(first_[p]),
              cells_.begin() + static_cast<std::ptrdiff_t>(first_[p + 1]));
  });
}

std::vector<std::uint8_t> pointsOfCells(const PointCells& around, std::span<const std::uint8_t> shown) {
  std::vector<std::uint8_t> mask(around.size());
  parallelFor(0, mask.size(), kGrain, [&](std::size_t p) {
    const auto cells = around.of(p);
    mask[p] = std::any_of(cells.begin(), cells.end(), [&](Index c) { return shown[c] != 0; }) ? 1 : 0;
  });
  return mask;
}

}  // namespace havs
