#pragma once
// Gradients at points by another way, and how far gradients of a smooth field are off.
#include <algorithm>
#include <cmath>
#include <vector>

#include "mesh/faces.h"
#include "support/meshes.h"

namespace havs::test {

/// What was not taken: the linear function through the point's value that fits its neighbours best, their squares
/// weighted by distance^-power.
inline std::vector<Vec3> leastSquares(const TetMesh& mesh, const std::vector<double>& values, double power) {
  std::vector<glm::dmat3> matrix(mesh.points.size(), glm::dmat3(0));
  std::vector<Vec3> right(mesh.points.size(), Vec3(0));
  std::vector<std::vector<Index>> neighbours(mesh.points.size());
  for (const Tetrahedron& t : mesh.tetrahedra)
    for (const Index v : t)
      for (const Index w : t)
        if (v != w) neighbours[v].push_back(w);
  std::vector<Vec3> result(mesh.points.size(), Vec3(0));
  for (std::size_t v = 0; v < mesh.points.size(); ++v) {
    auto& n = neighbours[v];
    std::sort(n.begin(), n.end());
    n.erase(std::unique(n.begin(), n.end()), n.end());
    for (const Index w : n) {
      const Vec3 r = mesh.points[w] - mesh.points[v];
      const double weight = std::pow(length(r), -power);
      matrix[v] += weight * glm::outerProduct(r, r);
      right[v] += weight * (values[w] - values[v]) * r;
    }
    if (!n.empty()) result[v] = glm::inverse(matrix[v]) * right[v];
  }
  return result;
}

/// Root mean squares of the differences from the gradient of test::smoothField.
struct GradientErrors {
  double inside = 0, all = 0;
};
inline GradientErrors errorsOf(const TetMesh& mesh, const std::vector<Vec3>& gradients) {
  const auto f = [](const Vec3& p) { return smoothField({p})[0]; };
  std::vector<bool> boundary(mesh.points.size(), false);
  const Faces faces = buildFaces(mesh);
  for (std::size_t face = 0; face < faces.size(); ++face)
    if (faces.isBoundary(face))
      for (const Index v : faces.vertices[face]) boundary[v] = true;
  GradientErrors errors;
  double inside = 0;
  for (std::size_t p = 0; p < mesh.points.size(); ++p) {
    constexpr double h = 1e-5;
    Vec3 exact;
    for (int axis = 0; axis < 3; ++axis) {
      Vec3 e{0};
      e[axis] = h;
      exact[axis] = (f(mesh.points[p] + e) - f(mesh.points[p] - e)) / (2 * h);
    }
    const double squared = dot(gradients[p] - exact, gradients[p] - exact);
    errors.all += squared;
    if (!boundary[p]) {
      errors.inside += squared;
      ++inside;
    }
  }
  errors.all = std::sqrt(errors.all / static_cast<double>(mesh.points.size()));
  errors.inside = std::sqrt(errors.inside / std::max(1.0, inside));
  return errors;
}

}  // namespace havs::test
