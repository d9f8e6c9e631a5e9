#pragma once
#include "scene/prepared_scene.h"

namespace havs {

/// How a mesh is cut before the eye, for renderers of one kind.
struct EyeCut {
  /// Of the cut from the eye, in the local frame. What is left out before it, along a ray at the angle a to the view
  /// direction, is kappa * distance / cos(a) of optical depth: on blunt fin by default, an error of the picture of 0.9
  /// times the distance (RMSE).
  double distance;
  /// Whether what lies beside the view is cut off too, far from the picture.
  bool sides;
};

/// Where places are known in double, the cut is needed for the rays to start at a face.
inline constexpr EyeCut kEyeCutInDouble{1e-6, false};
/// Where they are known in float, to 1e-7, and OpenGL clips at 1e-6. Points at the cut that lie as far aside as cells
/// are large come to 1e5 times the picture's width, where float knows no pixel any more: hence the sides, and the cut
/// wherever any of the mesh is beside or behind the eye.
inline constexpr EyeCut kEyeCutInFloat{1e-5, true};

/// Whether a mesh, which fills no more than the unit ball, may be where rays start: before they have gone
/// EyeCut::distance along the view direction. Never for parallel rays.
bool eyeIsNear(const View& view, const EyeCut& cut);

/// Whether a picture by a method that counts from where rays enter the mesh needs it cut before the eye. Without
/// EyeCut::sides that is where the eye is in a cell, or so near to one that a ray may come to the cell before the cut:
/// from an eye beside the mesh, in a hollow of it, rays enter it where they meet it. Parallel; at once where the eye is
/// not near.
bool needsEyeCut(const PreparedScene& prepared, const View& view, const EyeCut& cut);

/// The scene with only what lies beyond the plane across the view at EyeCut::distance before the eye: the section there
/// is where rays enter the mesh. The local frame is moved to have the eye as its origin, where numbers are finest
/// (viewFromOrigin); all else that is said of the mesh stays that of the whole, which must outlive it. Parallel, the same
/// for any number of threads.
PreparedScene cutBeforeEye(const PreparedScene& whole, const View& view, const EyeCut& cut);

/// The view for what cutBeforeEye returns.
View viewFromOrigin(View view);

}  // namespace havs
