#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "mesh/tet_mesh.h"

namespace havs {

/// The cells around each point.
class PointCells {
 public:
  /// Linear time, parallel; the result does not depend on the number of threads.
  PointCells(std::size_t points, std::span<const Tetrahedron> cells);
  std::size_t size() const { return first_.size() - 1; }
  /// Ascending.
  std::span<const Index> of(std::size_t point) const {
    return std::span(cells_).subspan(first_[point], first_[point + 1] - first_[point]);
  }

 private:
  std::vector<std::size_t> first_;
  std::vector<Index> cells_;
};

/// The points that any of the cells with `shown` != 0 has, as a PointMask (light/medium.h): where light is asked for
/// when only these cells are drawn. `shown`: one byte a cell. Parallel.
std::vector<std::uint8_t> pointsOfCells(const PointCells& around, std::span<const std::uint8_t> shown);

}  // namespace havs
