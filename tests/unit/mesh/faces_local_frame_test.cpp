#include <gtest/gtest.h>

#include <cmath>

#include "mesh/local_frame.h"
#include "support/meshes.h"

namespace havs {
namespace {

TEST(LocalFrame, OfTheCornerTetrahedronInClosedForm) {
  const TetMesh mesh = test::singleTetrahedron();
  const LocalFrame frame = localFrame(mesh);
  // The box is the unit cube; all four points are its corners.
  EXPECT_EQ(frame.center, Vec3(0.5));
  EXPECT_DOUBLE_EQ(frame.radius, std::sqrt(0.75));
  EXPECT_DOUBLE_EQ(frame.diagonal, std::sqrt(3.0));
  const auto points = localPoints(mesh, frame);
  for (const Vec3& p : points) EXPECT_NEAR(length(p), 1, 1e-15);
  EXPECT_NEAR(longestEdge(mesh, points), std::sqrt(2.0) / std::sqrt(0.75), 1e-15);
}

TEST(LocalFrame, PointsWithoutCellsDoNotCount) {
  TetMesh mesh = test::singleTetrahedron();
  mesh.points.push_back({100, 100, 100});
  EXPECT_EQ(localFrame(mesh).center, Vec3(0.5));
}

TEST(LocalFrame, AllPointsLieInTheUnitBallAtAnyMagnitude) {
  const TetMesh unit = test::box(3, test::Cut::six, 0.2);
  const auto expected = localPoints(unit, localFrame(unit));
  for (const double magnitude : {1e-300, 1e-160, 1.0, 1e160, 1e300}) {
    SCOPED_TRACE(magnitude);
    TetMesh mesh = unit;
    for (Vec3& p : mesh.points) p *= magnitude;
    const LocalFrame frame = localFrame(mesh);
    EXPECT_NEAR(frame.diagonal / magnitude, 2 * std::sqrt(3.0), 1e-14);
    const auto points = localPoints(mesh, frame);
    for (std::size_t i = 0; i < points.size(); ++i) {
      EXPECT_LE(length(points[i]), 1 + 1e-15);
      EXPECT_LT(length(points[i] - expected[i]), 1e-14);  // scaling rounds once a coordinate
    }
  }
}

TEST(LocalFrame, DoesNotDependOnThePlace) {
  const TetMesh unit = test::box(3);
  TetMesh moved = unit;
  for (Vec3& p : moved.points)
    p += Vec3(4096, -512, 64);  // exact: the points are multiples of 2/3 rounded at 1e-12 there
  const auto a = localPoints(unit, localFrame(unit)), b = localPoints(moved, localFrame(moved));
  for (std::size_t i = 0; i < a.size(); ++i) EXPECT_LT(length(a[i] - b[i]), 2e-12);
}

TEST(LocalFrame, OfCellsInOnePointIsFinite) {
  TetMesh mesh = test::singleTetrahedron();
  for (Vec3& p : mesh.points) p = {3, 4, 5};
  const LocalFrame frame = localFrame(mesh);
  EXPECT_EQ(frame.center, Vec3(3, 4, 5));
  EXPECT_EQ(frame.radius, 1);
  EXPECT_EQ(frame.diagonal, 0);
}

}  // namespace
}  // namespace havs
