#pragma once
#include <array>
#include <vector>

#include "scene/prepared_scene.h"

namespace havs {

/// Of each face, the corner that is not on it of the cell behind it as seen from its front, and of that behind it as
/// seen from its back; kNoIndex where there is none. Parallel.
std::vector<std::array<Index, 2>> cornersBehindFaces(const PreparedScene& prepared);

}  // namespace havs
