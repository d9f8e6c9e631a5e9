#pragma once
// What the fragments of a mesh carry, in float: where the scene's own arrays do not have it as it stands.
#include <array>
#include <vector>

#include "scene/prepared_scene.h"

namespace havs {

/// r, g, b; extinction as a fraction of the largest of the transfer function.
using ColorAndExtinction = std::array<float, 4>;

/// Cell data: of each face the scalars of the cells behind it as seen from its front and from its back, 0 for none.
std::vector<std::array<float, 2>> scalarsBehindFaces(const PreparedScene& prepared);
/// Cell data: the same as colours.
std::vector<std::array<ColorAndExtinction, 2>> colorsBehindFaces(const PreparedScene& prepared);
/// Point data: the colour of each point.
std::vector<ColorAndExtinction> colorsOfPoints(const PreparedScene& prepared);

}  // namespace havs
