#include "scene/camera.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/error.h"

namespace havs {
namespace {

constexpr double kRadiansPerDegree = std::numbers::pi / 180.0;
constexpr double kFar = 2;             ///< radii; beyond it, places are relative to the other of eye and target
constexpr double kFarthestEye = 1e15;  ///< radii: products of two such numbers are floats
/// A pixel at the mesh, in radii. Places are known to 1e-16 of the mesh and of the picture: four digits more than the
/// smallest pixel, ten more than what the mesh takes of the largest.
constexpr double kSmallestPixel = 1e-12, kLargestPixel = 1e6;
/// Half a side of a perspective picture, as a tangent: 179.99 degrees. What is cut off before an eye in the mesh
/// (scene/eye_cut.h) is 3e-4 radii of the longest ray there.
constexpr double kWidest = 1e4;

void checkCamera(const Camera& camera) {
  auto check = [](bool good, const char* what, const char* tryThis) {
    if (!good) failInput(what, "camera", tryThis);
  };
  check(std::isfinite(camera.azimuth) && std::isfinite(camera.elevation), "azimuth or elevation is not a finite number",
        "give degrees");
  check(std::isfinite(camera.zoom) && camera.zoom > 0, "zoom must be greater than 0", "1 shows the whole mesh");
  check(camera.fieldOfView > 0 && camera.fieldOfView < 180, "the field of view must lie between 0 and 180 degrees",
        "30 is the default");
  for (const auto* vector : {&camera.eye, &camera.target, &camera.up})
    check(!*vector || isFinite(**vector), "eye, target or up is not finite", "give three numbers");
  check(!camera.up || *camera.up != Vec3{0}, "up has no length", "[0, 1, 0] is the default");
  check(!camera.viewHeight || (std::isfinite(*camera.viewHeight) && *camera.viewHeight > 0),
        "the view height must be greater than 0", "give it in mesh units");
}

/// As normalize, for lengths whose square is too large or too small for a double.
Vec3 safelyNormalized(const Vec3& v) {
  const Vec3 a = abs(v);
  return normalize(v / std::max({a.x, a.y, a.z}));
}

/// The coordinate axis that lies most across `direction`.
Vec3 axisAcross(const Vec3& direction) {
  const Vec3 a = abs(direction);
  if (a.x <= a.y && a.x <= a.z) return {1, 0, 0};
  return a.y <= a.z ? Vec3{0, 1, 0} : Vec3{0, 0, 1};
}

/// Where the camera stands and which way is up, in the local frame.
struct Stand {
  Vec3 eye, target, up;
};

Stand standOf(const Camera& camera, const LocalFrame& frame, double fittedDistance) {
  Stand stand;
  stand.target = camera.target ? frame.toLocal(*camera.target) : Vec3{0};
  const double az = camera.azimuth * kRadiansPerDegree, el = camera.elevation * kRadiansPerDegree;
  if (camera.eye) {
    stand.eye = frame.toLocal(*camera.eye);
    stand.up = camera.up.value_or(Vec3{0, 1, 0});
  } else {
    const Vec3 outward{std::sin(az) * std::cos(el), std::sin(el), std::cos(az) * std::cos(el)};
    stand.eye = stand.target + fittedDistance * outward;
    // The way the eye moves as elevation grows: +y's projection, and defined at the poles too.
    stand.up = camera.up.value_or(Vec3{-std::sin(az) * std::sin(el), std::cos(el), -std::cos(az) * std::sin(el)});
  }
  return stand;
}

/// What places are relative to: the target of parallel rays, else the eye, so that a point of the mesh may be exactly
/// there; the other one where it lies nearer to a mesh far away.
Vec3 axisPoint(const Stand& stand, bool orthographic) {
  const Vec3 &first = orthographic ? stand.target : stand.eye, &second = orthographic ? stand.eye : stand.target;
  return length(first) > kFar && length(second) < length(first) ? second : first;
}

void checkExtent(const View& view) {
  const double distance = view.orthographic ? 1.0 : std::max(length(view.eye), 1.0);
  const double pixel = 2 * distance * std::min(view.halfWidth / view.width, view.halfHeight / view.height);
  const double half = std::max(view.halfWidth, view.halfHeight);
  if (!(pixel >= kSmallestPixel))
    failInput("the picture shows too little: a pixel is smaller than 1e-12 radii of the mesh", "camera", "zoom out");
  if (!view.orthographic && !(half <= kWidest))
    failInput("the picture shows too much: it is wider than 179.99 degrees", "camera",
              "take a smaller field of view, a larger zoom, or a picture less long");
  if (!(2 * std::max(view.halfWidth / view.width, view.halfHeight / view.height) <= kLargestPixel))
    failInput("the picture shows too much: a pixel is larger than 1e6 radii of the mesh", "camera", "zoom in");
}

}  // namespace

View makeView(const Camera& camera, const LocalFrame& frame, int width, int height) {
  checkCamera(camera);
  View view;
  view.orthographic = camera.projection == Projection::orthographic;
  view.width = width;
  view.height = height;
  const double aspect = static_cast<double>(width) / height;

  const double tangent = std::tan(0.5 * camera.fieldOfView * kRadiansPerDegree);
  const double fittedAngle = std::atan(tangent * std::min(1.0, aspect));
  const Stand stand = standOf(camera, frame, 1.0 / std::sin(fittedAngle));

  const Vec3 toTarget = stand.target - stand.eye;
  const double distance = length(toTarget);
  if (!(length(stand.eye) <= kFarthestEye) && !(view.orthographic && std::isfinite(distance)))
    failInput("the eye is too far away", "camera",
              "come nearer than 1e15 radii of the mesh, widen the field of view, or use an orthographic projection");
  if (!std::isfinite(distance)) failInput("the target is too far away", "camera", "give it in mesh units");
  if (!(distance > 0)) failInput("eye and target are the same point", "camera", "move one of them");
  view.forward = toTarget / distance;
  view.eye = stand.eye;
  view.center = axisPoint(stand, view.orthographic);

  Vec3 across = cross(view.forward, safelyNormalized(stand.up));
  if (length(across) < 1e-9) across = cross(view.forward, axisAcross(view.forward));
  across = normalize(across);  // of a short one, rounding is not across the view
  view.right = normalize(across - dot(across, view.forward) * view.forward);
  view.up = cross(view.right, view.forward);

  if (view.orthographic) {
    const double fitted = 1.0 / std::min(1.0, aspect);
    view.halfHeight = (camera.viewHeight ? 0.5 * *camera.viewHeight / frame.radius : fitted) / camera.zoom;
  } else {
    view.halfHeight = tangent / camera.zoom;
  }
  view.halfWidth = view.halfHeight * aspect;
  checkExtent(view);
  return view;
}

}  // namespace havs
