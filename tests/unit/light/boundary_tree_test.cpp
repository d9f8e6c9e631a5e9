#include "light/boundary_tree.h"

#include <gtest/gtest.h>

#include <set>

#include "unit/light/light_scene.h"

namespace havs::test {
namespace {

/// Faces that a fine walk along the stretch comes near to.
std::set<Index> facesTouched(const TetMesh& mesh, const Faces& faces, const Vec3& from, const Vec3& to) {
  std::set<Index> touched;
  for (std::size_t f = 0; f < faces.size(); ++f) {
    if (!faces.isBoundary(f)) continue;
    const Vec3 a = mesh.points[faces.vertices[f][0]], b = mesh.points[faces.vertices[f][1]] - a,
               c = mesh.points[faces.vertices[f][2]] - a, d = to - from;
    const double determinant = dot(b, cross(c, -d));
    if (determinant == 0) continue;
    const double u = dot(from - a, cross(c, -d)) / determinant, v = dot(b, cross(from - a, -d)) / determinant,
                 t = dot(b, cross(c, from - a)) / determinant;
    if (u >= 0 && v >= 0 && u + v <= 1 && t >= 0 && t <= 1) touched.insert(static_cast<Index>(f));
  }
  return touched;
}

TEST(BoundaryTree, LeavesOutNoFaceThatIsMetAndMostOthers) {
  const TetMesh mesh = nestedShells(2);
  const Faces faces = buildFaces(mesh);
  const BoundaryTree tree(mesh.points, faces);
  std::size_t visited = 0, lines = 0;
  for (const Vec3& from : {Vec3(0), Vec3(0.1, 0.45, -0.2), Vec3(-2, 0.3, 0.1), Vec3(1, 1, 1)})
    for (const Vec3& d : testDirections(60))
      for (const double length : {0.05, 0.7, 5.0}) {
        std::set<Index> near;
        tree.visitNear(from, from + length * d, [&](Index face) {
          EXPECT_TRUE(near.insert(face).second) << "twice";
          return true;
        });
        for (const Index face : facesTouched(mesh, faces, from, from + length * d)) EXPECT_TRUE(near.contains(face));
        visited += near.size();
        ++lines;
      }
  EXPECT_LT(visited, lines * faces.boundaryCount / 10);
}

TEST(BoundaryTree, StopsWhenToldTo) {
  const TetMesh mesh = box(3);
  const Faces faces = buildFaces(mesh);
  const BoundaryTree tree(mesh.points, faces);
  int visits = 0;
  tree.visitNear(Vec3(-2), Vec3(2), [&](Index) { return ++visits < 2; });
  EXPECT_EQ(visits, 2);
  EXPECT_GE(tree.reach(Vec3(1)), 2 * std::sqrt(3.0));
}

}  // namespace
}  // namespace havs::test
