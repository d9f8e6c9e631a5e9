#pragma once
// What the tests of the reference share: scenes without a file or a normalisation, rays, and an independent way through
// a mesh.
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <vector>

#include "reference/reference_renderer.h"
#include "support/meshes.h"

namespace havs::test {

/// The mesh as it is, in its own coordinates; scalars of [0, 1], one a point or one a cell.
inline PreparedScene sceneOf(TetMesh mesh, std::vector<double> scalars, ExtinctionCurve curve,
                             Centering centering = Centering::point) {
  PreparedScene prepared;
  prepared.points = mesh.points;
  prepared.faces = buildFaces(mesh);
  prepared.mesh = std::move(mesh);
  prepared.scalars = std::move(scalars);
  prepared.field.centering = centering;
  prepared.curve = std::move(curve);
  return prepared;
}

/// Extinction linear from `kappa0` at 0 to `kappa1` at 1, colour from green to red.
inline ExtinctionCurve rampCurve(double kappa0, double kappa1) {
  ExtinctionCurve curve;
  curve.knots = {{0, {0, 1, 0.5}, kappa0}, {1, {1, 0, 0.5}, kappa1}};
  return curve;
}
inline ExtinctionCurve constantCurve(double kappa) {
  ExtinctionCurve curve;
  curve.knots = {{0, {0.8, 0.4, 0.2}, kappa}, {1, {0.8, 0.4, 0.2}, kappa}};
  return curve;
}

/// A view from `eye` towards `target`; halfHeight as in View.
inline View viewOf(bool orthographic, const Vec3& eye, const Vec3& target, double halfHeight, int width, int height) {
  View view;
  view.orthographic = orthographic;
  view.width = width;
  view.height = height;
  view.eye = view.center = eye;
  view.forward = normalize(target - eye);
  const Vec3 up = std::abs(view.forward.y) < 0.9 ? Vec3{0, 1, 0} : Vec3{1, 0, 0};
  view.right = normalize(cross(view.forward, up));
  view.up = cross(view.right, view.forward);
  view.halfHeight = halfHeight;
  view.halfWidth = halfHeight * width / height;
  return view;
}

/// The ray of a pixel's centre: origin + t direction, direction of length 1; t >= 0 in a perspective view.
struct Ray {
  Vec3 origin, direction;
  double start;  ///< least t
};
inline Ray rayOf(const View& view, int x, int y) {
  const double u = (2.0 * (x + 0.5) / view.width - 1.0) * view.halfWidth;
  const double v = (1.0 - 2.0 * (y + 0.5) / view.height) * view.halfHeight;
  const Vec3 across = u * view.right + v * view.up;
  if (view.orthographic) return {view.center + across, view.forward, -1e300};
  return {view.eye, normalize(view.forward + across), 0};
}

/// A stretch of a ray: its ends, and the cell where there is one.
struct Stretch {
  double first, last;
  std::size_t cell = 0;
  double length() const { return std::max(0.0, last - first); }
};

/// The points with dot(normal, p) + offset >= 0.
struct HalfSpace {
  Vec3 normal;
  double offset;
};

/// The part of the ray in all of them.
inline Stretch clip(const Ray& ray, const std::vector<HalfSpace>& halves) {
  Stretch stretch{ray.start, 1e300};
  for (const HalfSpace& half : halves) {
    const double at0 = dot(half.normal, ray.origin) + half.offset, slope = dot(half.normal, ray.direction);
    if (slope > 0) stretch.first = std::max(stretch.first, -at0 / slope);
    if (slope < 0) stretch.last = std::min(stretch.last, -at0 / slope);
    if (slope == 0 && at0 < 0) return {0, 0};
  }
  return stretch;
}

inline Stretch throughBox(const Ray& ray, const Vec3& low, const Vec3& high) {
  std::vector<HalfSpace> sides;
  for (int axis = 0; axis < 3; ++axis) {
    Vec3 normal{0};
    normal[axis] = 1;
    sides.push_back({normal, -low[axis]});
    sides.push_back({-normal, high[axis]});
  }
  return clip(ray, sides);
}

/// Every cell clipped against the ray by the planes of its faces, in long double; near ones first.
inline std::vector<Stretch> clipCells(const TetMesh& mesh, const Ray& ray) {
  using Wide = long double;
  using Wide3 = glm::tvec3<Wide>;
  const Wide3 origin(ray.origin), direction(ray.direction);
  std::vector<Stretch> stretches;
  for (std::size_t c = 0; c < mesh.tetrahedra.size(); ++c) {
    Wide first = ray.start, last = 1e300L;
    for (std::size_t opposite = 0; opposite < 4; ++opposite) {
      std::array<Wide3, 4> p;
      for (std::size_t i = 0; i < 4; ++i) p[i] = Wide3(mesh.points[mesh.tetrahedra[c][(opposite + i) % 4]]);
      Wide3 normal = cross(p[2] - p[1], p[3] - p[1]);
      if (dot(normal, p[0] - p[1]) < 0) normal = -normal;
      const Wide at0 = dot(normal, origin - p[1]), slope = dot(normal, direction);
      if (slope > 0) first = std::max(first, -at0 / slope);
      if (slope < 0) last = std::min(last, -at0 / slope);
      if (slope == 0 && at0 < 0) last = -1e300L;
    }
    if (first < last) stretches.push_back({static_cast<double>(first), static_cast<double>(last), c});
  }
  std::sort(stretches.begin(), stretches.end(), [](const Stretch& a, const Stretch& b) { return a.first < b.first; });
  return stretches;
}

/// The linear interpolant of point values in a cell, at a point.
inline double scalarIn(const TetMesh& mesh, std::size_t cell, const std::vector<double>& values, const Vec3& point) {
  using Wide3 = glm::tvec3<long double>;
  std::array<Wide3, 4> r;
  const Tetrahedron& t = mesh.tetrahedra[cell];
  for (std::size_t i = 0; i < 4; ++i) r[i] = Wide3(mesh.points[t[i]]) - Wide3(point);
  auto volume = [&](std::size_t i, std::size_t j, std::size_t k) { return dot(cross(r[i], r[j]), r[k]); };
  const long double a = volume(1, 2, 3), b = volume(2, 0, 3), c = volume(0, 1, 3), d = volume(1, 0, 2);
  return static_cast<double>((a * values[t[0]] + b * values[t[1]] + c * values[t[2]] + d * values[t[3]]) /
                             (a + b + c + d));
}

/// The segments of all pixels, row by row.
inline std::vector<std::vector<CellSegment>> segmentsOf(const PreparedScene& prepared, const View& view,
                                                        const ReferenceTiles& tiles = {}) {
  std::vector<std::vector<CellSegment>> pixels(static_cast<std::size_t>(view.width * view.height));
  visitRays(
      prepared, view,
      [&](int x, int y, std::span<const CellSegment> segments) {
        pixels[static_cast<std::size_t>(y * view.width + x)].assign(segments.begin(), segments.end());
      },
      tiles);
  return pixels;
}

inline double lengthOf(const std::vector<CellSegment>& segments) {
  double sum = 0;
  for (const CellSegment& s : segments) sum += s.exit - s.entry;
  return sum;
}

/// Largest difference of the pixels' colours from expected(x, y); counts the pixels where something is expected.
struct Deviation {
  double most = 0;
  int x = -1, y = -1;
  std::size_t seen = 0;
};
inline Deviation deviation(const PreparedScene& prepared, const View& view,
                           const std::function<RayColor(int, int)>& expected) {
  const std::vector<RayColor> pixels = referencePixels(prepared, view);
  Deviation d;
  for (int y = 0; y < view.height; ++y)
    for (int x = 0; x < view.width; ++x) {
      const RayColor wanted = expected(x, y);
      const RayColor& found = pixels[static_cast<std::size_t>(y * view.width + x)];
      d.seen += wanted[3] > 0;
      for (std::size_t c = 0; c < 4; ++c)
        if (!(std::abs(found[c] - wanted[c]) <= d.most)) {
          d.most = std::abs(found[c] - wanted[c]);
          d.x = x;
          d.y = y;
        }
    }
  return d;
}
inline std::ostream& operator<<(std::ostream& out, const Deviation& d) {
  return out << d.most << " at " << d.x << "," << d.y;
}

/// Two views from outside, one of each projection, no axis of the mesh across or along them.
inline std::vector<View> obliqueViews(int size) {
  return {viewOf(false, {2.1, 1.7, 3.2}, {0.05, -0.02, 0.01}, 0.5, size, size),
          viewOf(true, {2.1, 1.7, 3.2}, {0.05, -0.02, 0.01}, 1.9, size, size)};
}

inline RayColor over(const RayColor& front, const RayColor& back) {
  RayColor sum = front;
  for (std::size_t c = 0; c < 4; ++c) sum[c] += (1 - front[3]) * back[c];
  return sum;
}

}  // namespace havs::test
