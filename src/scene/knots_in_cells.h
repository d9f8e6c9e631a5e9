#pragma once
#include "scene/prepared_scene.h"

namespace havs {

/// How many knots of the transfer function lie within the range of a cell's scalars, on the mean over those of a sample
/// of a few thousand cells that show anything: what `exact` costs grows with it. 0 for cell data.
double meanKnotsInCells(const PreparedScene& prepared);

}  // namespace havs
