#pragma once
#include "scene/prepared_scene.h"

namespace havs {

/// How a mesh is cut before the eye, for renderers of one kind.
struct EyeCut {
  /// What is left out of a ray before the cut, in the local frame, at most: of the longest, along which the cut is
  /// `distance` away. A plane nearer than kNearestCut is not cut at, so that the longest rays of a very wide view lose
  /// kNearestCut times their length for one unit of depth. On blunt fin by default an error of the picture of 0.9 times
  /// what is left out (RMSE).
  double distance;
  /// Whether what lies beside the view is cut off too, far from the picture.
  bool sides;
  /// Where a pixel at the mesh is smaller than this, of the local frame, the sides are cut off and the frame turned,
  /// wherever the eye is.
  double finestPixel;
};

/// Where places are known in double, the cut is needed for the rays to start at a face.
inline constexpr EyeCut kEyeCutInDouble{1e-6, false, 0};
/// Where they are known in float, to 1e-7, and OpenGL clips at 1e-6. Points at the cut that lie as far aside as cells
/// are large come to 1e5 times the picture's width, where float knows no pixel any more: hence the sides, and the cut
/// wherever any of the mesh is beside or behind the eye. Float is off by 1/30 of the finest pixel.
inline constexpr EyeCut kEyeCutInFloat{1e-5, true, 3e-6};
/// Twice what points count as on a plane by (kOnPlane in mesh/half_space.h).
inline constexpr double kNearestCut = 2e-8;

/// How far before the eye the plane of the cut is.
double planeDistance(const View& view, const EyeCut& cut);
/// What is left out of the longest ray.
double leftOut(const View& view, const EyeCut& cut);

/// Whether a mesh, which fills no more than the unit ball, may be where rays start: before they have come to the cut.
/// Never for parallel rays.
bool eyeIsNear(const View& view, const EyeCut& cut);

/// Whether the view shows so little that EyeCut::finestPixel asks for a cut.
bool showsTooFine(const View& view, const EyeCut& cut);

/// Whether a picture by a method that counts from where rays enter the mesh needs it cut before the eye. Without
/// EyeCut::sides that is where the eye is in a cell, or so near to one that a ray may come to the cell before the cut:
/// from an eye beside the mesh, in a hollow of it, rays enter it where they meet it. Parallel; at once where the eye is
/// not near.
bool needsEyeCut(const PreparedScene& prepared, const View& view, const EyeCut& cut);

/// The scene with only what the view may show: beyond the plane across the view before the eye, where the section is
/// where rays enter the mesh; with EyeCut::sides within planes far beside the picture. The local frame has its origin
/// at the eye (an eye far from the mesh: at the point of its axis nearest to the mesh's centre) and its axes along
/// right, up and backward, so that numbers are finest where the picture is (viewOfCut). All else that is said of the
/// mesh stays that of the whole, which must outlive it. Parallel, the same for any number of threads.
PreparedScene cutBeforeEye(const PreparedScene& whole, const View& view, const EyeCut& cut);

/// The view in the frame of what cutBeforeEye returned for it.
View viewOfCut(const PreparedScene& part, View view);

}  // namespace havs
