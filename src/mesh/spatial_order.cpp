#include "mesh/spatial_order.h"

#include <algorithm>
#include <cstdint>
#include <limits>

#include "core/parallel.h"
#include "mesh/radix_sort.h"

namespace havs {
namespace {

constexpr double kLargest = std::numeric_limits<double>::max();

/// Puts two zero bits before each of the ten low bits.
std::uint32_t spread(std::uint32_t x) {
  x = (x | (x << 16)) & 0x030000FFu;
  x = (x | (x << 8)) & 0x0300F00Fu;
  x = (x | (x << 4)) & 0x030C30C3u;
  x = (x | (x << 2)) & 0x09249249u;
  return x;
}

struct Bounds {
  Vec3 low{kLargest};
  Vec3 high{-kLargest};
};

Bounds boundsOf(std::span<const Vec3> points) {
  return parallelReduce(
      0, points.size(), kGrain, Bounds{},
      [&](std::size_t first, std::size_t last) {
        Bounds box;
        for (std::size_t i = first; i < last; ++i) {
          if (!isFinite(points[i])) continue;
          box.low = min(box.low, points[i]);
          box.high = max(box.high, points[i]);
        }
        return box;
      },
      [](const Bounds& a, const Bounds& b) {
        return Bounds{min(a.low, b.low), max(a.high, b.high)};
      });
}

/// Places within a box as numbers along the curve. Halves are taken before sums, so that nothing overflows.
class MortonCode {
 public:
  explicit MortonCode(const Bounds& box) : middle_(0.5 * box.low + 0.5 * box.high) {
    const Vec3 half = 0.5 * box.high - 0.5 * box.low;
    const double largest = std::max({half.x, half.y, half.z});
    perUnit_ = largest > 0 && largest < kLargest ? 512 / largest : 0;
  }
  std::uint32_t operator()(const Vec3& p) const {
    return quantised(p.x - middle_.x) | (quantised(p.y - middle_.y) << 1) | (quantised(p.z - middle_.z) << 2);
  }

 private:
  std::uint32_t quantised(double offset) const {
    const double place = offset * perUnit_ + 512;
    return place > 0 ? spread(static_cast<std::uint32_t>(std::min(place, 1023.0))) : 0;  // no number: 0
  }

  Vec3 middle_;
  double perUnit_ = 0;
};

template <class Place>
std::vector<Index> sortedAlong(const MortonCode& code, std::size_t count, const Place& place) {
  std::vector<KeyedIndex> items(count);
  parallelFor(0, count, kGrain, [&](std::size_t i) { items[i] = {code(place(i)), static_cast<Index>(i)}; });
  std::vector<Index> order;
  RadixSorter().sort(items, order);
  return order;
}

}  // namespace

SpatialNumbers spatialNumbers(std::span<const Vec3> points, std::span<const Tetrahedron> tetrahedra) {
  const MortonCode code(boundsOf(points));
  return {sortedAlong(code, points.size(), [&](std::size_t i) { return points[i]; }),
          sortedAlong(code, tetrahedra.size(), [&](std::size_t c) {
            const auto& [i, j, k, l] = tetrahedra[c];
            return 0.25 * points[i] + 0.25 * points[j] + 0.25 * points[k] + 0.25 * points[l];
          })};
}

TetMesh renumbered(const TetMesh& mesh, const SpatialNumbers& numbers) {
  TetMesh result;
  result.points.resize(numbers.points.size());
  std::vector<Index> newNumber(numbers.points.size());
  parallelFor(0, numbers.points.size(), kGrain, [&](std::size_t i) {
    result.points[i] = mesh.points[numbers.points[i]];
    newNumber[numbers.points[i]] = static_cast<Index>(i);
  });
  result.tetrahedra.resize(numbers.cells.size());
  parallelFor(0, numbers.cells.size(), kGrain, [&](std::size_t c) {
    const auto& [i, j, k, l] = mesh.tetrahedra[numbers.cells[c]];
    result.tetrahedra[c] = {newNumber[i], newNumber[j], newNumber[k], newNumber[l]};
  });
  result.sourceCells = mesh.sourceCells;
  return result;
}

std::vector<double> renumbered(const std::vector<double>& values, const std::vector<Index>& numbers) {
  std::vector<double> result(numbers.size());
  parallelFor(0, numbers.size(), kGrain, [&](std::size_t i) { result[i] = values[numbers[i]]; });
  return result;
}

}  // namespace havs
