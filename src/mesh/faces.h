#pragma once
#include <array>
#include <vector>

#include "mesh/tet_mesh.h"

namespace havs {

/// The unique faces of a mesh. The normal (v1 - v0) x (v2 - v0) of `vertices` points out of cells[0], into cells[1];
/// a boundary face has cells[1] == kNoIndex, so its normal points out of the mesh.
struct Faces {
  std::vector<std::array<Index, 3>> vertices;
  std::vector<std::array<Index, 2>> cells;
  std::vector<std::array<Index, 4>> ofCell;  ///< ofCell[c][i]: the face of cell c opposite to its vertex i
  std::size_t boundaryCount = 0;
  bool plain = true;  ///< no triangle is a face of more than two cells, or of two on one side of it
  std::size_t size() const { return vertices.size(); }
  bool isBoundary(std::size_t face) const { return cells[face][1] == kNoIndex; }
};

/// Linear time, parallel; numbered by their first cells, in the order of the cells. Cells must be right-handed
/// (repairMesh). Cells on opposite sides of one triangle are paired in the order of the cell numbers, the lower being
/// cells[0]; a cell's face that finds no partner (more than two cells share the triangle, or two that overlap on one
/// side of it) is a boundary face of its own. So entries and exits balance along every ray, whatever the cells. The
/// result does not depend on the number of threads. Throws Error{input} for 2^29 cells or more.
Faces buildFaces(const TetMesh& mesh);

}  // namespace havs
