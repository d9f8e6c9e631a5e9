// A k-buffer counts from where rays enter the mesh. A ray that starts inside does so at no face, and faces that the eye
// nearly touches come out of the projection with coordinates beyond any precision. Both are gone when the mesh begins a
// little before the eye.
#include "scene/eye_cut.h"

#include <cmath>

#include "mesh/half_space.h"
#include "scene/clip_scene.h"

namespace havs {
namespace {

/// How far rays have gone, at most, when they come to the cut: those of the picture's corners.
double longestWay(const View& view, double distance) {
  return distance * std::sqrt(1 + view.halfWidth * view.halfWidth + view.halfHeight * view.halfHeight);
}

}  // namespace

bool eyeIsNear(const View& view, double distance) {
  return !view.orthographic && length(view.eye) <= 1 + longestWay(view, distance);
}

bool needsEyeCut(const PreparedScene& prepared, const View& view, double distance) {
  return eyeIsNear(view, distance) && reachesMesh(prepared, view.eye, longestWay(view, distance));
}

PreparedScene cutBeforeEye(const PreparedScene& whole, const View& view, double distance) {
  const HalfSpace before{view.forward, dot(view.forward, view.eye) + distance};
  PreparedScene part = cutScene(whole, partInside(whole.mesh.tetrahedra, whole.points, before));
  part.faces = buildFaces(part.mesh);
  return part;
}

}  // namespace havs
