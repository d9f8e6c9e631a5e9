// A k-buffer counts from where rays enter the mesh. A ray that starts inside does so at no face, and faces that the eye
// nearly touches come out of the projection with coordinates beyond any precision. Both are gone when the mesh begins a
// little before the eye.
#include "scene/eye_cut.h"

#include <cmath>

#include "core/parallel.h"
#include "mesh/half_space.h"
#include "scene/clip_scene.h"

namespace havs {
namespace {

/// Where the sides are cut, in widths and heights of the view. Float knows a place there to 1/600 of a pixel of a
/// picture of 1024 x 1024. Cut nearer, cells that lead from one part of the picture to another are missing to the order
/// of the faces.
constexpr double kAside = 50;

/// How far rays have gone, at most, when they come to the cut: those of the picture's corners.
double longestWay(const View& view, const EyeCut& cut) {
  return cut.distance * std::sqrt(1 + view.halfWidth * view.halfWidth + view.halfHeight * view.halfHeight);
}

/// The half space on the inner side of a plane through the eye that `slope` leads aside along `axis`.
HalfSpace besideView(const View& view, const Vec3& axis, double slope) {
  const Vec3 normal = normalize(slope * view.forward - axis);
  return {normal, dot(normal, view.eye)};
}

/// The part of `scene` inside, which remembers what it was cut from.
PreparedScene partOf(const PreparedScene& scene, std::vector<MeshCut> before, const HalfSpace& half) {
  before.push_back(partInside(scene.mesh.tetrahedra, scene.points, half));
  PreparedScene part = cutScene(scene, before.back());
  part.cuts = std::move(before);
  return part;
}

}  // namespace

bool eyeIsNear(const View& view, const EyeCut& cut) {
  return !view.orthographic && length(view.eye) <= 1 + longestWay(view, cut);
}

bool needsEyeCut(const PreparedScene& prepared, const View& view, const EyeCut& cut) {
  return eyeIsNear(view, cut) && (cut.sides || reachesMesh(prepared, view.eye, longestWay(view, cut)));
}

PreparedScene cutBeforeEye(const PreparedScene& whole, const View& view, const EyeCut& cut) {
  const HalfSpace before{view.forward, dot(view.forward, view.eye) + cut.distance};
  PreparedScene part = partOf(whole, {}, before);
  if (cut.sides)
    for (const double sign : {-1.0, 1.0}) {
      part = partOf(part, std::move(part.cuts), besideView(view, sign * view.right, kAside * view.halfWidth));
      part = partOf(part, std::move(part.cuts), besideView(view, sign * view.up, kAside * view.halfHeight));
    }
  part.uncut = &whole;
  part.origin = view.eye;
  part.frame.center += part.frame.radius * view.eye;
  parallelFor(0, part.points.size(), 16384, [&](std::size_t p) { part.points[p] -= view.eye; });
  part.faces = buildFaces(part.mesh);
  return part;
}

View viewFromOrigin(View view) {
  view.eye = view.center = Vec3{0};
  return view;
}

}  // namespace havs
