#pragma once
#include <cstddef>
#include <span>
#include <vector>

#include "mesh/cell_shapes.h"
#include "mesh/tet_mesh.h"

namespace havs {

/// Cuts one cell after the other, appending tetrahedra and, where a cell needs one, a point in its middle.
///
/// A linear cell becomes the cone from its lowest point number over the faces that do not touch that point, each face
/// fanned from its own lowest point number. So a quadrilateral is cut at the same diagonal from both sides, and
/// pyramids, wedges and hexahedra come out as in Dompierre, Labbe, Vallet, Camarero 1999.
class CellCutter {
 public:
  CellCutter(std::vector<Vec3>& points, std::vector<Field>& pointFields) : points_(points), pointFields_(pointFields) {}

  /// `cell` is the number that the tetrahedra of this cell get in sourceCells().
  void cut(Index cell, const CellShape& shape, std::span<const Index> corners);
  /// `stream`: VTK's face stream (cells.h), checked.
  void cutPolyhedron(Index cell, std::span<const Index> stream);

  std::vector<Tetrahedron>& tetrahedra() { return tetrahedra_; }
  const std::vector<Index>& sourceCells() const { return sourceCells_; }
  /// Cells with a point more than once, whose pieces of no volume were left out.
  std::size_t degenerateCells() const { return degenerateCells_; }
  /// Those of them that were nothing but pieces of no volume.
  std::size_t collapsedCells() const { return collapsedCells_; }

 private:
  using Triangle = std::array<Index, 3>;

  void cutFromLowestPoint(const CellShape& shape, std::span<const Index> corners);
  void cutFromCentre(const CellShape& shape, std::span<const Index> corners);
  void cutQuadraticTetra(std::span<const Index> corners);
  void gatherSurface(const CellShape& shape, std::span<const Index> corners);
  void fan(std::span<const Index> polygon);
  bool replaceThreeByTwo(Index lowest, Index opposite);
  void add(const Tetrahedron& tetrahedron);
  Index addCentre(std::vector<Index> around);

  std::vector<Vec3>& points_;
  std::vector<Field>& pointFields_;
  std::vector<Tetrahedron> tetrahedra_;
  std::vector<Index> sourceCells_;
  std::vector<Triangle> surface_;  // of the cell at hand
  Index cell_ = 0;
  bool droppedPiece_ = false;
  std::size_t degenerateCells_ = 0;
  std::size_t collapsedCells_ = 0;
};

}  // namespace havs
