#pragma once
#include <vector>

#include "mesh/tet_mesh.h"

namespace havs {

/// Whether every cell names four different points, and no triangle is a face of more than two cells or of two on one
/// side of it: then there are no duplicate cells and no overfull faces. Linear time, parallel, and quicker than the two
/// below.
bool sharesOnlyPlainFaces(const TetMesh& mesh);

/// For each cell 1 when an earlier cell has the same four points, in any order. Linear time, parallel.
std::vector<char> duplicateCells(const TetMesh& mesh);

/// Faces that more than two cells share, and the lowest number of a cell that has such a face. Cells that name a point
/// twice have no faces here. Linear time, parallel.
struct OverfullFaces {
  std::size_t count = 0;
  std::size_t firstCell = 0;
};
OverfullFaces overfullFaces(const TetMesh& mesh);

}  // namespace havs
