#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "mesh/tet_mesh.h"

namespace havs {

/// Cells of any type as a file holds them, before they become tetrahedra.
/// `types` are VTK's cell type numbers (10 tetra, 11 voxel, 12 hexahedron, 13 wedge, 14 pyramid, 24 quadratic tetra,
/// ..., 42 polyhedron),
/// `connectivity[offsets[i] .. offsets[i+1])` the points of cell i in VTK's order; for a polyhedron VTK's face
/// stream: number of faces, then for each face its number of points and the points.
struct CellSoup {
  std::vector<Vec3> points;
  std::vector<std::uint8_t> types;
  std::vector<std::int64_t> offsets;  ///< types.size() + 1 of them
  std::vector<std::int64_t> connectivity;
  std::vector<Field> pointFields;
  std::vector<Field> cellFields;  ///< tuples() == types.size()
  std::vector<std::string> notes;
};

/// Cuts every three-dimensional cell into tetrahedra that conform across shared quadrilaterals: each quadrilateral is
/// cut at the diagonal from its lowest point number (Dompierre, Labbe, Vallet, Camarero 1999: "How to subdivide
/// pyramids, prisms and hexahedra into tetrahedra"); polyhedra from their centre; quadratic cells at their mid nodes.
/// Points that are added (centres) get the mean of the point data. Cells of lower dimension are left out and noted.
/// Unless all cells are tetrahedra, identical points are welded first (and noted), so that pieces that meet in doubled
/// points conform; of cells that name a point twice the pieces without volume are left out (and noted).
/// Throws Error{input} for point numbers out of range (with the cell's number), unknown cell types, no 3-D cell at all.
/// `where` (the file) begins each message.
TetMesh cutIntoTetrahedra(CellSoup cells, const std::string& where);

/// A curvilinear grid of nx * ny * nz points (x fastest) cut in five a cell with alternating parity of i + j + k, so
/// that neighbours conform. Cells with a point where `blank` is 0 are left out (empty `blank`: none). Fields:
/// pointFields as given; cellFields one tuple a grid cell. Throws Error{input}, `where` first, for arrays that do not
/// fit the size and grids without a cell.
TetMesh cutStructuredGrid(std::array<std::size_t, 3> size, std::vector<Vec3> points, std::vector<int> blank,
                          std::vector<Field> pointFields, std::vector<Field> cellFields, const std::string& where);

}  // namespace havs
