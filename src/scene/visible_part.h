#pragma once
#include <optional>
#include <vector>

#include "scene/prepared_scene.h"

namespace havs {

/// Of each cell, 1 where the transfer function shows anything at some scalar that the cell has (point data: between the
/// least and the greatest of its corners), else 0: such a cell adds nothing to a picture that composites. Parallel.
std::vector<unsigned char> shownCells(const PreparedScene& prepared);

/// Whether there is any other. Parallel.
bool hasClearCells(const PreparedScene& prepared);

/// The scene with only these cells: points that none of them has are left out, and faces to cells that are left out
/// become boundary. All that is said of the mesh besides (frame, longest edge, curve, field, notes) stays that of the
/// whole, so that the same camera gives the same picture. Cells, points and faces keep their order. Nothing where all
/// cells are shown. Linear, parallel; the result does not depend on the number of threads. `prepared` must outlive the
/// part.
std::optional<PreparedScene> visiblePart(const PreparedScene& prepared);

}  // namespace havs
