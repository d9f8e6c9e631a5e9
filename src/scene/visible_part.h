#pragma once
#include <optional>
#include <vector>

#include "scene/prepared_scene.h"
#include "scene/shown_scalars.h"

namespace havs {

/// Of each cell, 1 where anything of `what` shows at some scalar that the cell has (point data: between the least and
/// the greatest of its corners), else 0: such a cell adds nothing to a picture that composites. Parallel.
std::vector<unsigned char> shownCells(const PreparedScene& prepared, const WhatShows& what = {});

/// Whether there is any other. Parallel.
bool hasClearCells(const PreparedScene& prepared, const WhatShows& what = {});

/// The scene with only these cells: points that none of them has are left out, and faces to cells that are left out
/// become boundary. All that is said of the mesh besides (frame, longest edge, curve, isosurfaces, field, notes) stays
/// that of the whole, so that the same camera gives the same picture. Cells, points and faces keep their order. Nothing
/// where all cells are shown. Linear, parallel; the result does not depend on the number of threads. `prepared` must
/// outlive the part.
std::optional<PreparedScene> visiblePart(const PreparedScene& prepared, const WhatShows& what = {});

}  // namespace havs
