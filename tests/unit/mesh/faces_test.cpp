#include "mesh/faces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "core/parallel.h"
#include "support/meshes.h"

namespace havs {
namespace {

Vec3 cellCentre(const TetMesh& mesh, Index cell) {
  Vec3 sum{0};
  for (const Index v : mesh.tetrahedra[cell]) sum += mesh.points[v];
  return sum / 4.0;
}

Vec3 areaVector(const TetMesh& mesh, const std::array<Index, 3>& v) {
  return 0.5 * cross(mesh.points[v[1]] - mesh.points[v[0]], mesh.points[v[2]] - mesh.points[v[0]]);
}

std::array<Index, 3> ascending(std::array<Index, 3> v) {
  std::sort(v.begin(), v.end());
  return v;
}

std::vector<std::pair<std::string, TetMesh>> conformingMeshes() {
  return {{"single", test::singleTetrahedron()},
          {"five", test::box(4, test::Cut::five)},
          {"six", test::box(3, test::Cut::six, 0.2)},
          {"ball", test::ball(6)},
          {"hole", test::boxWithHole(6)},
          {"shells", test::nestedShells(1)},
          {"cycle", test::visibilityCycle()},
          {"layers", test::stretchedLayers(6, 2)}};
}

TEST(BuildFaces, CountsOfABoxInClosedForm) {
  constexpr std::size_t n = 5;
  const Faces five = buildFaces(test::box(n, test::Cut::five));
  EXPECT_EQ(five.boundaryCount, 12 * n * n);                             // six sides of n^2 squares, two triangles each
  EXPECT_EQ(five.size(), (4 * 5 * n * n * n + five.boundaryCount) / 2);  // 4 cells = 2 inner + boundary
  const Faces six = buildFaces(test::box(n, test::Cut::six));
  EXPECT_EQ(six.boundaryCount, 12 * n * n);
  EXPECT_EQ(six.size(), (4 * 6 * n * n * n + six.boundaryCount) / 2);
}

TEST(BuildFaces, AgreesWithAMapOfSortedTriples) {
  for (const auto& [name, mesh] : conformingMeshes()) {
    SCOPED_TRACE(name);
    std::map<std::array<Index, 3>, std::vector<Index>> expected;
    for (Index c = 0; c < mesh.tetrahedra.size(); ++c)
      for (std::size_t i = 0; i < 4; ++i) {
        const auto& t = mesh.tetrahedra[c];
        expected[ascending({t[(i + 1) % 4], t[(i + 2) % 4], t[(i + 3) % 4]})].push_back(c);
      }
    const Faces faces = buildFaces(mesh);
    ASSERT_EQ(faces.size(), expected.size());
    std::size_t boundary = 0;
    for (std::size_t f = 0; f < faces.size(); ++f) {
      std::vector<Index> cells{faces.cells[f][0]};
      if (!faces.isBoundary(f)) cells.push_back(faces.cells[f][1]);
      boundary += faces.isBoundary(f) ? 1 : 0;
      EXPECT_EQ(expected[ascending(faces.vertices[f])], cells);
    }
    EXPECT_EQ(faces.boundaryCount, boundary);
  }
}

TEST(BuildFaces, NormalsPointFromTheFirstCellToTheSecond) {
  for (const auto& [name, mesh] : conformingMeshes()) {
    SCOPED_TRACE(name);
    const Faces faces = buildFaces(mesh);
    for (std::size_t f = 0; f < faces.size(); ++f) {
      const Vec3 normal = areaVector(mesh, faces.vertices[f]);
      const Vec3& on = mesh.points[faces.vertices[f][0]];
      EXPECT_LT(dot(normal, cellCentre(mesh, faces.cells[f][0]) - on), 0);
      if (!faces.isBoundary(f)) {
        EXPECT_GT(dot(normal, cellCentre(mesh, faces.cells[f][1]) - on), 0);
      }
    }
  }
}

TEST(BuildFaces, FacesOfACellAreOppositeToItsVertices) {
  const TetMesh mesh = test::box(3, test::Cut::five, 0.2);
  const Faces faces = buildFaces(mesh);
  for (Index c = 0; c < mesh.tetrahedra.size(); ++c)
    for (std::size_t i = 0; i < 4; ++i) {
      const Index face = faces.ofCell[c][i];
      EXPECT_TRUE(faces.cells[face][0] == c || faces.cells[face][1] == c);
      const auto& t = mesh.tetrahedra[c];
      EXPECT_EQ(ascending(faces.vertices[face]), ascending({t[(i + 1) % 4], t[(i + 2) % 4], t[(i + 3) % 4]}));
    }
}

// The boundary is closed (its area vectors add up to nothing) and encloses the volume of the cells (divergence
// theorem).
TEST(BuildFaces, BoundaryEnclosesTheCells) {
  for (const auto& [name, mesh] : conformingMeshes()) {
    SCOPED_TRACE(name);
    const Faces faces = buildFaces(mesh);
    Vec3 area{0};
    double enclosed = 0, volume = 0;
    for (std::size_t f = 0; f < faces.size(); ++f) {
      if (!faces.isBoundary(f)) continue;
      const Vec3 normal = areaVector(mesh, faces.vertices[f]);
      area += normal;
      enclosed += dot(normal, mesh.points[faces.vertices[f][0]]) / 3;
    }
    for (std::size_t c = 0; c < mesh.tetrahedra.size(); ++c) volume += test::volume(mesh, c);
    EXPECT_LT(length(area), 1e-12);  // rounding of some thousand terms of order 0.1
    EXPECT_NEAR(enclosed, volume, 1e-12);
  }
}

// A triangle with two cells above and one below: above and below are paired by number, the other is boundary.
TEST(BuildFaces, PairsCellsOnOppositeSidesOfAnOverfullFace) {
  TetMesh mesh;
  mesh.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 2}, {0, 0, -1}};
  mesh.tetrahedra = {{0, 1, 2, 4}, {0, 1, 2, 3}, {0, 2, 1, 5}};
  const Faces faces = buildFaces(mesh);
  EXPECT_EQ(faces.size(), 11u);  // 12 cell faces, one pair
  EXPECT_EQ(faces.boundaryCount, 10u);
  EXPECT_EQ(faces.cells[faces.ofCell[0][3]], (std::array<Index, 2>{0, 2}));
  EXPECT_EQ(faces.ofCell[2][3], faces.ofCell[0][3]);
  EXPECT_EQ(faces.cells[faces.ofCell[1][3]], (std::array<Index, 2>{1, kNoIndex}));
}

// Two cells on one side of a triangle overlap: a ray enters both.
TEST(BuildFaces, DoesNotPairCellsOnOneSide) {
  TetMesh mesh;
  mesh.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 2}};
  mesh.tetrahedra = {{0, 1, 2, 3}, {0, 1, 2, 4}, {0, 1, 2, 3}};
  const Faces faces = buildFaces(mesh);
  EXPECT_EQ(faces.size(), 12u);
  EXPECT_EQ(faces.boundaryCount, 12u);
}

TEST(BuildFaces, SameForAnyNumberOfThreads) {
  const TetMesh mesh = test::box(14, test::Cut::six, 0.2);  // 16,464 cells: several blocks
  auto build = [&](std::size_t threads) {
    const ThreadLimit limit(threads);
    return buildFaces(mesh);
  };
  const Faces one = build(1);
  for (int run = 0; run < 4; ++run) {
    const Faces many = build(4);
    EXPECT_EQ(one.vertices, many.vertices);
    EXPECT_EQ(one.cells, many.cells);
    EXPECT_EQ(one.ofCell, many.ofCell);
  }
}

}  // namespace
}  // namespace havs
