#include "light/point_gradients.h"

#include <gtest/gtest.h>

#include <random>

#include "unit/light/gradient_errors.h"
#include "unit/light/light_scene.h"

namespace havs::test {
namespace {

std::vector<Vec3> gradientsOf(const TetMesh& mesh, const std::vector<double>& scalars, bool cellData = false,
                              PointMask mask = {}) {
  const PointCells around(mesh.points.size(), mesh.tetrahedra);
  return pointGradients(mesh.points, mesh.tetrahedra, around, scalars, cellData, mask);
}

/// Shortest height of the cells around each point: a value rounded by u moves the gradient there by u / height.
std::vector<double> leastHeights(const TetMesh& mesh) {
  std::vector<double> least(mesh.points.size(), 1e300);
  for (std::size_t c = 0; c < mesh.tetrahedra.size(); ++c) {
    const Tetrahedron& t = mesh.tetrahedra[c];
    for (std::size_t i = 0; i < 4; ++i) {
      const Vec3 &a = mesh.points[t[(i + 1) % 4]], &b = mesh.points[t[(i + 2) % 4]], &d = mesh.points[t[(i + 3) % 4]];
      const double height = 6 * volume(mesh, c) / length(cross(b - a, d - a));
      for (const Index v : t) least[v] = std::min(least[v], height);
    }
  }
  return least;
}

TEST(PointGradients, ExactForLinearFieldsAlsoAtTheBoundaryAndOnSlivers) {
  const Vec3 g{0.21, -0.17, 0.08};
  for (const TetMesh& mesh : {box(6, Cut::six, 0.2), box(6, Cut::five, 0.2), boxWithHole(6), nestedShells(2),
                              oGrid(4, 20, 4), stretchedLayers(10, 4.0), singleTetrahedron()}) {
    const std::vector<double> heights = leastHeights(mesh);
    const PointCells around(mesh.points.size(), mesh.tetrahedra);
    const std::vector<Vec3> found = gradientsOf(mesh, linearField(mesh.points, g));
    for (std::size_t p = 0; p < found.size(); ++p)
      if (!around.of(p).empty()) {
        EXPECT_LE(length(found[p] - g), std::max(1e-15, 1e-15 / heights[p]));
      }
  }
}

// The values of nodes at 1e-6 heights are exact here, so that only the arithmetic rounds.
TEST(PointGradients, SliversOfExactValuesTo1e12) {
  TetMesh mesh = gridMesh(3, 3, 3, Cut::six, [](int i, int j, int k) { return Vec3(i, j * 0x1p-20, k); });
  const Vec3 g{0.25, 0x1p10, 0.125};
  const std::vector<Vec3> found = gradientsOf(mesh, linearField(mesh.points, g));
  for (const Vec3& gradient : found) EXPECT_LE(length(gradient - g), 1e-12 * length(g));
}

TEST(PointGradients, FlatCellsGiveNumbers) {
  TetMesh mesh = singleTetrahedron();
  mesh.points[3] = {0.3, 0.3, 0};
  for (const Vec3& gradient : gradientsOf(mesh, {0, 1, 0.5, 0.2})) EXPECT_EQ(gradient, Vec3(0));
  mesh = box(3);
  mesh.points[21] = mesh.points[22];  // cells of one edge less
  for (const Vec3& gradient : gradientsOf(mesh, smoothField(mesh.points))) EXPECT_TRUE(isFinite(gradient));
}

TEST(PointGradients, OfCellData) {
  TetMesh mesh = box(10, Cut::six);
  const Vec3 g{0.2, -0.1, 0.3};
  std::vector<double> values;
  for (const Tetrahedron& t : mesh.tetrahedra) {
    Vec3 center{0};
    for (const Index v : t) center += 0.25 * mesh.points[v];
    values.push_back(0.5 + dot(g, center));
  }
  const std::vector<Vec3> found = gradientsOf(mesh, values, true);
  for (std::size_t p = 0; p < found.size(); ++p) {
    const Vec3 a = abs(mesh.points[p]);
    // The averages of even surroundings are exact; two layers away from the boundary all that counts is.
    const bool isInside = std::max({a.x, a.y, a.z}) < 0.7;
    EXPECT_LE(length(found[p] - g), isInside ? 1e-14 : 0.6 * length(g));
  }
}

TEST(PointGradients, OnlyWhatIsAskedFor) {
  const TetMesh mesh = box(3);
  std::vector<std::uint8_t> mask(mesh.points.size(), 0);
  mask[5] = 1;
  const std::vector<Vec3> all = gradientsOf(mesh, smoothField(mesh.points));
  const std::vector<Vec3> some = gradientsOf(mesh, smoothField(mesh.points), false, mask);
  for (std::size_t p = 0; p < some.size(); ++p) EXPECT_EQ(some[p], mask[p] ? all[p] : Vec3(0));
}

// Why this mean: it is nearer to the truth than least squares of neighbours, weighted or not, on grids moved at random
// and on stretched ones. What TetGen's meshes say is measured by bench_light (docs/08-effects-data.md).
TEST(PointGradients, NearerThanLeastSquares) {
  for (const TetMesh& mesh : {box(12, Cut::six), box(12, Cut::six, 0.25), ball(12), stretchedLayers(12, 1.3),
                              stretchedLayers(12, 1.6), stretchedLayers(12, 3.0)}) {
    const std::vector<double> values = smoothField(mesh.points);
    const GradientErrors mean = errorsOf(mesh, gradientsOf(mesh, values));
    for (const double power : {0.0, 2.0}) {
      const GradientErrors squares = errorsOf(mesh, leastSquares(mesh, values, power));
      EXPECT_LT(mean.inside, squares.inside);
      if (power == 0) {
        EXPECT_LT(mean.all, squares.all);
      }
    }
  }
}

// First order at least: half the edge, half the error.
TEST(PointGradients, ErrorsFallWithTheCells) {
  double before = 1e300;
  for (const int n : {6, 12, 24}) {
    const TetMesh mesh = box(n, Cut::six, 0.2);
    const double error = errorsOf(mesh, gradientsOf(mesh, smoothField(mesh.points))).all;
    EXPECT_LT(error, 0.55 * before);
    before = error;
  }
}

}  // namespace
}  // namespace havs::test
