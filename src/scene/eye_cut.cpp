// A k-buffer counts from where rays enter the mesh. A ray that starts inside does so at no face, and faces that the eye
// nearly touches come out of the projection with coordinates beyond any precision. Both are gone when the mesh begins a
// little before the eye. And where a picture shows a millionth of the mesh, coordinates of the mesh are beyond the
// precision of float: those of what is left beside the picture, along its axes, are not.
#include "scene/eye_cut.h"

#include <algorithm>
#include <cmath>

#include "core/parallel.h"
#include "mesh/half_space.h"
#include "scene/clip_scene.h"

namespace havs {
namespace {

/// Where the sides are cut, in widths and heights of the view. Float knows a place there to 1/600 of a pixel of a
/// picture of 1024 x 1024. Cut nearer, cells that lead from one part of the picture to another are missing to the order
/// of the faces. Farther aside, up to this, where the planes would come too near to the picture for kOnPlane.
constexpr double kAside = 50, kFarthestAside = 1e4;

double longestRay(const View& view) { return view.rayScale(0, 0); }

/// How many widths or heights aside the cut is, for half a side of the picture at its nearest place.
double asideOf(double half) { return std::clamp(10 * kOnPlane / half, kAside, kFarthestAside); }

/// The origin of the frame that the cut has.
Vec3 originOf(const View& view, const EyeCut& cut) {
  return eyeIsNear(view, cut) ? view.eye : view.center - view.depth(view.center) * view.forward;
}

/// The half space on the inner side of a plane along the rays, beside the picture on the side of `axis`.
HalfSpace besideView(const View& view, const Vec3& origin, const Vec3& axis, double half, double nearest) {
  const double aside = asideOf(half * nearest) * half;
  if (view.orthographic) return {-axis, -dot(axis, origin) - aside};
  const Vec3 normal = normalize(aside * view.forward - axis);
  const double distance = view.depth(origin) - view.depth(view.eye);
  return {normal, dot(normal, origin + distance * aside * axis)};
}

/// What is kept lies in all of them.
std::vector<HalfSpace> halfSpacesOf(const View& view, const EyeCut& cut) {
  const bool near = eyeIsNear(view, cut);
  const double distance = planeDistance(view, cut);
  std::vector<HalfSpace> halves;
  if (near) halves.push_back({view.forward, view.depth(view.eye) + distance});
  if (!cut.sides) return halves;
  const double nearest = near ? distance : view.orthographic ? 1.0 : length(view.eye);
  const Vec3 origin = originOf(view, cut);
  for (const double sign : {-1.0, 1.0}) {
    halves.push_back(besideView(view, origin, sign * view.right, view.halfWidth, nearest));
    halves.push_back(besideView(view, origin, sign * view.up, view.halfHeight, nearest));
  }
  return halves;
}

/// The part of `scene` inside, which remembers what it was cut from.
PreparedScene partOf(const PreparedScene& scene, std::vector<MeshCut> before, const HalfSpace& half) {
  before.push_back(partInside(scene.mesh.tetrahedra, scene.points, half));
  PreparedScene part = cutScene(scene, before.back());
  part.cuts = std::move(before);
  return part;
}

/// Columns: right, up and backward of the view, so that the frame stays right-handed.
glm::dmat3 axesOf(const View& view) { return {view.right, view.up, -view.forward}; }

}  // namespace

double planeDistance(const View& view, const EyeCut& cut) {
  return std::max(kNearestCut, cut.distance / longestRay(view));
}

double leftOut(const View& view, const EyeCut& cut) { return planeDistance(view, cut) * longestRay(view); }

bool eyeIsNear(const View& view, const EyeCut& cut) {
  return !view.orthographic && length(view.eye) <= 1 + leftOut(view, cut);
}

bool showsTooFine(const View& view, const EyeCut& cut) {
  const double distance = view.orthographic ? 1.0 : std::max(length(view.eye), 1.0);
  const double pixel = 2 * distance * std::min(view.halfWidth / view.width, view.halfHeight / view.height);
  return pixel < cut.finestPixel;
}

bool needsEyeCut(const PreparedScene& prepared, const View& view, const EyeCut& cut) {
  if (showsTooFine(view, cut)) return true;
  return eyeIsNear(view, cut) && (cut.sides || reachesMesh(prepared, view.eye, leftOut(view, cut)));
}

PreparedScene cutBeforeEye(const PreparedScene& whole, const View& view, const EyeCut& cut) {
  const Vec3 origin = originOf(view, cut);
  PreparedScene part;
  const PreparedScene* from = &whole;
  for (const HalfSpace& half : halfSpacesOf(view, cut)) {
    part = partOf(*from, std::move(part.cuts), half);
    from = &part;
  }
  part.uncut = &whole;
  part.origin = origin;
  part.axes = axesOf(view);
  part.frame.center += part.frame.radius * origin;
  const glm::dmat3 turn = transpose(part.axes);
  parallelFor(0, part.points.size(), 16384, [&](std::size_t p) { part.points[p] = turn * (part.points[p] - origin); });
  part.faces = buildFaces(part.mesh);
  return part;
}

View viewOfCut(const PreparedScene& part, View view) {
  view.eye = {0, 0, view.depth(part.origin) - view.depth(view.eye)};
  view.center = Vec3{0};
  view.right = {1, 0, 0};
  view.up = {0, 1, 0};
  view.forward = {0, 0, -1};
  return view;
}

}  // namespace havs
