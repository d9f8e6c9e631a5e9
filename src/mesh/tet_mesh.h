#pragma once
#include <array>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "core/vec.h"

namespace havs {

using Index = std::uint32_t;
inline constexpr Index kNoIndex = std::numeric_limits<Index>::max();
/// Four point numbers; right-handed when dot(cross(p1 - p0, p2 - p0), p3 - p0) > 0 (VTK's sense).
using Tetrahedron = std::array<Index, 4>;

/// Values at the points or at the cells: `components` values for each, one tuple after another, in the file's unit.
struct Field {
  std::string name;
  int components = 1;
  std::vector<double> values;
  std::size_t tuples() const { return values.size() / static_cast<std::size_t>(components); }
};

/// A tetrahedral mesh as read and cut into tetrahedra, in the file's coordinates and order.
struct TetMesh {
  std::vector<Vec3> points;
  std::vector<Tetrahedron> tetrahedra;
  std::vector<Field> pointFields;  ///< tuples() == points.size()
  std::vector<Field> cellFields;   ///< tuples() == tetrahedra.size(): a cut cell hands its value to its tetrahedra
  std::size_t sourceCells = 0;     ///< three-dimensional cells of the file before cutting
  std::vector<std::string> notes;  ///< what reading changed or left out, one sentence each ("left out 12 triangles")
};

}  // namespace havs
