#pragma once
#include <vector>

#include "mesh/tet_mesh.h"

namespace havs {

enum class CellState : unsigned char {
  sound,      ///< right-handed
  inverted,   ///< left-handed
  flat,       ///< |volume| <= 1e-15 times the cube of the longest edge
  notFinite,  ///< a coordinate of a point is infinite or no number
};

/// The state of each cell; safe for coordinates from 1e-300 to 1e300. Parallel.
std::vector<CellState> cellStates(const TetMesh& mesh);

}  // namespace havs
