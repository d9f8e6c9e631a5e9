#pragma once
#include <cstddef>
#include <span>
#include <vector>

#include "mesh/defects.h"
#include "mesh/faces.h"
#include "mesh/tet_mesh.h"

namespace havs {

/// Cells that reach into another one, and the lowest of their numbers.
struct OverlappingCells {
  std::size_t count = 0;
  std::size_t first = 0;
};

/// Of a mesh of right-handed cells and its faces: those that another cell cannot be parted from by a plane without
/// going deeper than 1e-6 of the mesh's radius. `numbers`: what each cell is called in the answer. Cells that lie near
/// each other should have near places (mesh/spatial_order.h). Where no cell of the boundary overlaps, none does, so
/// only these are looked at then; else all are. Parallel.
OverlappingCells overlappingCells(const TetMesh& mesh, const Faces& faces, std::span<const Index> numbers);

/// The same of any mesh, of the cells that repairMesh would leave, by their numbers in `mesh`.
OverlappingCells overlappingCells(const TetMesh& mesh);

/// Puts it into its row of `defects`.
void enterOverlaps(std::vector<Defect>& defects, const OverlappingCells& found);
/// Takes the row away, where none were looked for.
void leaveOutOverlaps(std::vector<Defect>& defects);

}  // namespace havs
