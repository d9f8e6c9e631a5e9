#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "mesh/tet_mesh.h"

namespace havs {

/// One kind of defect, as counted and as repaired.
struct Defect {
  std::string name;  ///< snake_case: inverted_cells, flat_cells, duplicate_cells, overfull_faces, overlapping_cells,
                     ///< unreferenced_points, non_finite_points, non_finite_scalars
  std::size_t count = 0;  ///< how many
  std::size_t first = 0;  ///< number (from 0) of the first cell concerned; of the first point for the kinds of points,
                          ///< and for non_finite_scalars unless only cell values are; meaningless when count is 0
  std::string repair;     ///< what repairMesh does about it, one phrase
};

/// "inverted_cells: 12, the first number 7; turned"
std::string describe(const Defect& defect);

/// Counts every kind of defect (rows with count 0 too, so that a reader sees what was looked for). Linear time,
/// parallel.
/// flat: |volume| <= 1e-15 times the cube of the cell's longest edge; overfull face: a face of more than two cells.
/// Without `overlaps`, which are most of the time that it takes, there is no row of overlapping_cells.
std::vector<Defect> inspectMesh(const TetMesh& mesh, bool overlaps = true);

/// Whether all cells are right-handed and not flat, and all points are finite and used: repairMesh could find nothing
/// but cells of the same points. Linear time, parallel.
bool isSound(const TetMesh& mesh);

/// inspectMesh of a mesh that is sound and whose faces are `plain` (mesh/faces.h): of such only the fields are looked
/// at.
std::vector<Defect> inspectFields(const TetMesh& mesh);

/// Turns inverted cells, leaves out flat and duplicate cells (the first stays), cells with a non-finite point, and
/// points that no cell uses.
/// Non-finite scalars stay (cells that touch them are holes when drawn, see withoutHoles). Returns the mended mesh.
/// Throws Error{input} when no cell is left.
TetMesh repairMesh(TetMesh mesh);

/// Merges points whose three coordinates are bit-identical and whose point data are too (-0 equals 0). Returns how many
/// went.
std::size_t weldPoints(TetMesh& mesh);

}  // namespace havs
