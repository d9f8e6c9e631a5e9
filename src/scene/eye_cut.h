#pragma once
#include "scene/prepared_scene.h"

namespace havs {

/// How far before the eye a mesh is cut, in the local frame, by what renderers know places in. What is left out before
/// it, along a ray at the angle a to the view direction, is kappa * distance / cos(a) of optical depth: on blunt fin by
/// default, an error of the picture of 0.9 times the distance (RMSE).
inline constexpr double kEyeCutInDouble = 1e-6;
/// Places are good to 1e-7; OpenGL clips at 1e-6, and at 4e-6 views of 1 degree of a TetGen mesh had holes.
inline constexpr double kEyeCutInFloat = 1e-5;

/// Whether a mesh, which fills no more than the unit ball, may be where rays start: before they have gone `distance`
/// along the view direction. Never for parallel rays.
bool eyeIsNear(const View& view, double distance);

/// Whether a picture by a method that counts from where rays enter the mesh needs it cut at `distance` before the eye:
/// the eye is in a cell, or so near to one that a ray may come to the cell before the cut. An eye beside the mesh, in a
/// hollow of it, needs no cut: its rays enter the mesh where they meet it. Parallel; at once where the eye is not near.
bool needsEyeCut(const PreparedScene& prepared, const View& view, double distance);

/// The scene with only what lies beyond the plane across the view at `distance` before the eye: the section there is
/// where rays enter the mesh. All that is said of the mesh besides stays that of the whole. Parallel, the same for any
/// number of threads.
PreparedScene cutBeforeEye(const PreparedScene& whole, const View& view, double distance);

}  // namespace havs
