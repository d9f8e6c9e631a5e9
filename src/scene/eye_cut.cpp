// A k-buffer counts from where rays enter the mesh. A ray that starts inside does so at no face, and faces that the eye
// nearly touches come out of the projection with coordinates beyond any precision. Both are gone when the mesh begins a
// little before the eye.
#include "scene/eye_cut.h"

#include <array>
#include <atomic>
#include <cmath>

#include "core/parallel.h"
#include "mesh/half_space.h"
#include "scene/clip_scene.h"

namespace havs {

namespace {

/// Of the rays of the view, where they come to the cut.
double farthestReach(const View& view) {
  return kEyeCut * std::sqrt(1 + view.halfWidth * view.halfWidth + view.halfHeight * view.halfHeight);
}

}  // namespace

bool eyeIsNear(const View& view) { return !view.orthographic && length(view.eye) <= 1 + farthestReach(view); }

bool needsEyeCut(const PreparedScene& prepared, const View& view) {
  return eyeIsNear(view) && reachesMesh(prepared, view.eye, farthestReach(view));
}

PreparedScene cutBeforeEye(const PreparedScene& whole, const View& view) {
  const HalfSpace before{view.forward, dot(view.forward, view.eye) + kEyeCut};
  PreparedScene part = cutScene(whole, partInside(whole.mesh.tetrahedra, whole.points, before));
  part.faces = buildFaces(part.mesh);
  return part;
}

}  // namespace havs
