#pragma once
#include <array>
#include <vector>

#include "mesh/tet_mesh.h"

namespace havs {

/// The vertices of the face opposite to vertex i of a right-handed cell, so that the normal points out of the cell.
inline constexpr std::array<std::array<std::size_t, 3>, 4> kOutwardFace{{{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}}};

inline std::array<Index, 3> outwardFace(const Tetrahedron& cell, std::size_t opposite) {
  const auto& [a, b, c] = kOutwardFace[opposite];
  return {cell[a], cell[b], cell[c]};
}

/// Which faces of cells lie on opposite sides of one triangle.
struct FaceMates {
  /// of[c][i]: 4 * other cell + place of the vertex opposite to its face; kNoIndex where there is none.
  std::vector<std::array<Index, 4>> of;
  /// Whether no triangle is a face of more than two cells, or of two on one side of it.
  bool plain = true;
};

/// Linear time, parallel, the same for any number of threads. Cells must name four different points. Cells on opposite
/// sides of one triangle are paired in the order of their numbers; what stays alone has no mate.
FaceMates matchFaces(const TetMesh& mesh);

}  // namespace havs
