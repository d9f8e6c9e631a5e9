#pragma once
#include <span>
#include <vector>

#include "mesh/tet_mesh.h"

namespace havs {

/// The cells around each point.
class PointCells {
 public:
  /// Linear time, parallel; the result does not depend on the number of threads.
  PointCells(std::size_t points, std::span<const Tetrahedron> cells);
  /// Ascending.
  std::span<const Index> of(std::size_t point) const {
    return std::span(cells_).subspan(first_[point], first_[point + 1] - first_[point]);
  }

 private:
  std::vector<std::size_t> first_;
  std::vector<Index> cells_;
};

}  // namespace havs
