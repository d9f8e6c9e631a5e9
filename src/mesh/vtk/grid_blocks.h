#pragma once
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "mesh/cells.h"
#include "mesh/tet_mesh.h"

namespace havs {

/// A structured grid as a file holds it, before it is cut into tetrahedra.
struct StructuredBlock {
  std::array<std::size_t, 3> size{};  ///< points along each direction, x fastest, each at least 2
  std::vector<Vec3> points;
  std::vector<int> blank;                ///< one a point, 0 = left out; empty: none is
  std::vector<std::uint8_t> hiddenCell;  ///< one a grid cell, 1 = left out; empty: none is
  std::vector<Field> pointFields;
  std::vector<Field> cellFields;  ///< one tuple a grid cell
};

/// The blocks of a file, of either kind.
struct GridBlocks {
  std::vector<CellSoup> cells;
  std::vector<StructuredBlock> structured;
  std::vector<std::string> notes;
};

/// One tetrahedral mesh of all blocks. Fields that every block has (same name and components) stay, others are noted.
/// Blocks of cells are joined before they are cut, so that the cuts conform across blocks, too; structured blocks are
/// cut one by one. `where` (the file) begins each message. Throws Error{input}.
TetMesh meshFromBlocks(GridBlocks blocks, const std::string& where);

}  // namespace havs
