#pragma once
#include "scene/prepared_scene.h"

namespace havs {

/// How far before the eye the mesh is cut, local units.
inline constexpr double kEyeCut = 1e-5;

/// Whether a mesh, which fills no more than the unit ball, may be where rays start. Never for parallel rays.
bool eyeIsNear(const View& view);

/// Whether a picture of a mesh as k-buffers draw it needs the mesh cut before the eye: it is in a cell, or so near to
/// one that a ray may come to the cell within kEyeCut. Parallel; at once where the eye is not near.
bool needsEyeCut(const PreparedScene& prepared, const View& view);

/// The scene with only what lies beyond the plane across the view at kEyeCut before the eye: the section there is
/// where rays enter the mesh. All that is said of the mesh besides stays that of the whole. Parallel, the same for any
/// number of threads.
PreparedScene cutBeforeEye(const PreparedScene& whole, const View& view);

}  // namespace havs
