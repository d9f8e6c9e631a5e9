#pragma once
// What the tests of light share: media without files or normalisation, and an independent way along a ray.
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <vector>

#include "light/directions.h"
#include "light/mesh_tracer.h"
#include "support/meshes.h"

namespace havs::test {

struct LightScene {
  TetMesh mesh;
  std::vector<double> scalars;
  ExtinctionCurve curve;
  bool cellData;
  Faces faces;
  LightScene(TetMesh m, std::vector<double> s, ExtinctionCurve c, bool cells = false)
      : mesh(std::move(m)), scalars(std::move(s)), curve(std::move(c)), cellData(cells), faces(buildFaces(mesh)) {}
  Medium medium() const { return {mesh.points, mesh.tetrahedra, faces, scalars, cellData, curve}; }
};

/// kappa linear between knots (s, kappa).
inline ExtinctionCurve curveOf(const std::vector<std::array<double, 2>>& knots) {
  ExtinctionCurve curve;
  for (const auto& [s, kappa] : knots) {
    curve.knots.push_back({s, {1, 1, 1}, kappa});
    curve.maximumKappa = std::max(curve.maximumKappa, kappa);
  }
  return curve;
}
inline ExtinctionCurve constantKappa(double kappa) { return curveOf({{0, kappa}, {1, kappa}}); }

inline LightScene constantScene(TetMesh mesh, double kappa) {
  std::vector<double> scalars(mesh.points.size(), 0.4);
  return {std::move(mesh), std::move(scalars), constantKappa(kappa)};
}

struct Range {
  double first, last;
  double length() const { return std::max(0.0, last - first); }
};

/// Where a ray is in a closed box.
inline Range throughBox(const Vec3& start, const Vec3& direction, const Vec3& low, const Vec3& high) {
  Range range{0, 1e300};
  for (int axis = 0; axis < 3; ++axis) {
    const double p = start[axis], d = direction[axis];
    if (d == 0) {
      if (p < low[axis] || p > high[axis]) return {0, 0};
      continue;
    }
    range.first = std::max(range.first, ((d > 0 ? low : high)[axis] - p) / d);
    range.last = std::min(range.last, ((d > 0 ? high : low)[axis] - p) / d);
  }
  return range;
}

/// Directions along no plane of a grid.
inline std::vector<Vec3> generalDirections(std::size_t count) {
  std::vector<Vec3> directions = fibonacciDirections(count);
  const Vec3 axis = normalize(Vec3(1, 2, 3.1));
  for (Vec3& d : directions)  // turned by 0.7
    d = normalize(std::cos(0.7) * d + std::sin(0.7) * cross(axis, d) + (1 - std::cos(0.7)) * dot(axis, d) * axis);
  return directions;
}

/// Directions along the edges and faces of grids, and others.
inline std::vector<Vec3> testDirections(std::size_t general) {
  std::vector<Vec3> directions = generalDirections(general);
  for (int x = -1; x <= 1; ++x)
    for (int y = -1; y <= 1; ++y)
      for (int z = -1; z <= 1; ++z)
        if (x != 0 || y != 0 || z != 0) directions.push_back(normalize(Vec3(x, y, z)));
  return directions;
}

/// A ray inside one cell, with the scalars at both ends.
struct CellStretch {
  Range range;
  double sFirst, sLast;
};

/// Every cell clipped against the ray by the planes of its faces, in long double.
inline std::vector<CellStretch> clipCells(const LightScene& scene, const Vec3& start, const Vec3& direction) {
  using Wide = long double;
  using Wide3 = glm::tvec3<Wide>;
  std::vector<CellStretch> stretches;
  for (std::size_t c = 0; c < scene.mesh.tetrahedra.size(); ++c) {
    const Tetrahedron& cell = scene.mesh.tetrahedra[c];
    Wide first = 0, last = 1e300L;
    std::array<Wide, 4> height, slope;  // barycentric coordinate i is height[i] + t slope[i]
    for (std::size_t i = 0; i < 4; ++i) {
      std::array<Wide3, 4> p;
      for (std::size_t k = 0; k < 4; ++k) p[k] = Wide3(scene.mesh.points[cell[(i + k) % 4]]) - Wide3(start);
      const Wide3 normal = cross(p[2] - p[1], p[3] - p[1]);
      const Wide whole = dot(normal, p[0] - p[1]);
      height[i] = -dot(normal, p[1]) / whole;
      slope[i] = dot(normal, Wide3(direction)) / whole;
      if (slope[i] > 0) first = std::max(first, -height[i] / slope[i]);
      if (slope[i] < 0) last = std::min(last, -height[i] / slope[i]);
      if (slope[i] == 0 && height[i] < 0) last = -1;
    }
    if (!(first < last)) continue;
    const auto scalarAt = [&](Wide t) {
      if (scene.cellData) return scene.scalars[c];
      Wide s = 0;
      for (std::size_t i = 0; i < 4; ++i) s += (height[i] + t * slope[i]) * Wide(scene.scalars[cell[i]]);
      return std::clamp(static_cast<double>(s), 0.0, 1.0);
    };
    stretches.push_back({{static_cast<double>(first), static_cast<double>(last)}, scalarAt(first), scalarAt(last)});
  }
  return stretches;
}

/// Largest |opticalDepth - expected| over points of cells and directions, of points inside and at the boundary.
struct Worst {
  double inside = 0, atBoundary = 0;
};
inline Worst worstDepth(const LightScene& scene, const std::vector<Vec3>& directions,
                        const std::function<double(const Vec3&, const Vec3&)>& expected) {
  std::vector<bool> boundary(scene.mesh.points.size(), false);
  for (std::size_t f = 0; f < scene.faces.size(); ++f)
    if (scene.faces.isBoundary(f))
      for (const Index v : scene.faces.vertices[f]) boundary[v] = true;
  const MeshTracer tracer(scene.medium());
  const PointCells around(scene.mesh.points.size(), scene.mesh.tetrahedra);
  PointRays rays(tracer);
  Worst worst;
  for (std::size_t p = 0; p < scene.mesh.points.size(); ++p) {
    if (around.of(p).empty()) continue;
    rays.startAt(static_cast<Index>(p));
    double& most = boundary[p] ? worst.atBoundary : worst.inside;
    for (const Vec3& d : directions) {
      const double error = std::abs(rays.opticalDepth(d) - expected(scene.mesh.points[p], d));
      if (!(error <= most)) most = error;
    }
  }
  return worst;
}

}  // namespace havs::test
