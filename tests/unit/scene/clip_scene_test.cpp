// What of a mesh is drawn: clip planes, boxes and the threshold, against the volumes and cells that they mean.
#include "scene/clip_scene.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "core/error.h"
#include "support/meshes.h"

namespace havs {
namespace {

constexpr double kRounding = 1e-12;  // thousands of pieces, a rounding each

/// [-1, 1]^3 with the field x + 2 y, at the points or at the cells (of their first points).
TetMesh box(bool cellData = false) {
  TetMesh mesh = test::box(5, test::Cut::six, 0.25, 4);
  const auto value = [](const Vec3& p) { return p.x + 2 * p.y; };
  if (cellData) {
    mesh.cellFields = {{"s", 1, {}}};
    for (const Tetrahedron& t : mesh.tetrahedra) mesh.cellFields[0].values.push_back(value(mesh.points[t[0]]));
  } else {
    mesh.pointFields = {{"s", 1, test::pointValues(mesh.points, value)}};
  }
  return mesh;
}

PreparedScene prepared(const Scene& scene, TetMesh mesh = box()) {
  StageTimes stages;
  return prepareScene(scene, std::move(mesh), stages);
}

double volumeOf(const PreparedScene& scene) {
  double sum = 0;
  for (std::size_t c = 0; c < scene.mesh.tetrahedra.size(); ++c) sum += test::volume(scene.mesh, c);
  return sum;
}

double boundaryArea(const PreparedScene& scene) {
  double sum = 0;
  const auto& p = scene.mesh.points;
  for (std::size_t f = 0; f < scene.faces.size(); ++f) {
    const auto& [a, b, c] = scene.faces.vertices[f];
    if (scene.faces.isBoundary(f)) sum += 0.5 * length(cross(p[b] - p[a], p[c] - p[a]));
  }
  return sum;
}

TEST(ClipScene, KeepsTheHalfThatTheNormalPointsTo) {
  Scene scene;
  scene.clipPlanes = {{{0.4, 7, -9}, {2, 0, 0}}};  // anywhere on the plane, of any length
  const PreparedScene part = prepared(scene);
  EXPECT_NEAR(volumeOf(part), 4 * 0.6, kRounding);
  for (const Vec3& p : part.mesh.points) EXPECT_GE(p.x, 0.4 - 1e-15);
}

// A face that cells on both sides have is no boundary, so an area too large would show where they do not fit together.
TEST(ClipScene, BoxesKeepTheirInsideOrTheirOutside) {
  Scene scene;
  scene.clipBoxes = {{{-0.5, -0.3, -2}, {0.3, 0.6, 0.7}}};
  const PreparedScene inside = prepared(scene);
  EXPECT_NEAR(volumeOf(inside), 0.8 * 0.9 * 1.7, kRounding);
  EXPECT_NEAR(boundaryArea(inside), 2 * (0.8 * 0.9 + 0.9 * 1.7 + 1.7 * 0.8), kRounding);

  scene.clipBoxes[0].keepsInside = false;
  const PreparedScene outside = prepared(scene);
  EXPECT_NEAR(volumeOf(outside), 8 - 0.8 * 0.9 * 1.7, kRounding);
  // The box comes in through the side at z = -1: its four walls and its end are new, its mouth is gone.
  EXPECT_NEAR(boundaryArea(outside), 24 + 2 * 1.7 * (0.8 + 0.9), kRounding);

  scene.clipBoxes[0].low.z = -0.7;  // a hollow
  const PreparedScene hollow = prepared(scene);
  EXPECT_NEAR(volumeOf(hollow), 8 - 0.8 * 0.9 * 1.4, kRounding);
  EXPECT_NEAR(boundaryArea(hollow), 24 + 2 * (0.8 * 0.9 + 0.9 * 1.4 + 1.4 * 0.8), kRounding);
}

TEST(ClipScene, KeepsWhatIsInAllOfThem) {
  Scene scene;
  scene.clipPlanes = {{{0, 0, 0}, {1, 0, 0}}, {{0, 0, 0}, {0, 0, -1}}};
  scene.clipBoxes = {{{-3, -3, -3}, {3, 0.5, 3}}, {{0.25, 0.25, -0.75}, {0.5, 3, -0.25}, false}};
  const double expected = 1 * 1.5 * 1 - 0.25 * 0.25 * 0.5;
  EXPECT_NEAR(volumeOf(prepared(scene)), expected, kRounding);
  std::swap(scene.clipPlanes[0], scene.clipPlanes[1]);
  std::swap(scene.clipBoxes[0], scene.clipBoxes[1]);
  EXPECT_NEAR(volumeOf(prepared(scene)), expected, kRounding);
}

TEST(ClipScene, KeepsWhatDescribesTheWhole) {
  const PreparedScene whole = prepared({});
  Scene scene;
  scene.clipPlanes = {{{0.4, 0, 0}, {1, 0, 0}}};
  scene.threshold = {-1.0, 2.0};
  const PreparedScene part = prepared(scene);
  EXPECT_LT(part.mesh.tetrahedra.size(), whole.mesh.tetrahedra.size());
  EXPECT_EQ(part.frame.center, whole.frame.center);
  EXPECT_EQ(part.frame.radius, whole.frame.radius);
  EXPECT_EQ(part.frame.diagonal, whole.frame.diagonal);
  EXPECT_EQ(part.longestEdge, whole.longestEdge);
  EXPECT_EQ(part.knotsInCells, whole.knotsInCells);
  EXPECT_EQ(part.field.minimum, whole.field.minimum);
  EXPECT_EQ(part.field.maximum, whole.field.maximum);
  EXPECT_EQ(part.curve.domain, whole.curve.domain);
  EXPECT_EQ(part.curve.unitLength, whole.curve.unitLength);
}

TEST(ClipScene, ScalarsOfPointsAreLinearAndThoseOfCellsCopied) {
  Scene scene;
  scene.clipPlanes = {{{0.1, 0.2, 0}, {1, 2, 3}}};
  const PreparedScene points = prepared(scene);
  for (std::size_t i = 0; i < points.points.size(); ++i) {
    const Vec3& p = points.mesh.points[i];
    ASSERT_NEAR(points.scalars[i], points.curve.normalise(p.x + 2 * p.y), 1e-14);
    ASSERT_LE(length(points.frame.toLocal(p) - points.points[i]), 1e-15);
  }
  const PreparedScene wholeCells = prepared({}, box(true)), cells = prepared(scene, box(true));
  ASSERT_EQ(cells.scalars.size(), cells.mesh.tetrahedra.size());
  double whole = 0, kept = 0;
  for (const double s : wholeCells.scalars) whole = std::max(whole, s);
  for (const double s : cells.scalars) kept = std::max(kept, s);
  EXPECT_EQ(whole, 1);
  EXPECT_LE(kept, 1);
}

// VTK's threshold: all points of a cell, both ends included.
TEST(ClipScene, ThresholdKeepsCellsWithAllPointsWithin) {
  const PreparedScene whole = prepared({});
  Scene scene;
  scene.threshold = {-1.0, 1.4};
  const PreparedScene part = prepared(scene);
  std::size_t expected = 0;
  const auto within = [&](Index p) {
    const double value = whole.mesh.points[p].x + 2 * whole.mesh.points[p].y;
    return value >= -1.0 && value <= 1.4;
  };
  for (const Tetrahedron& t : whole.mesh.tetrahedra)
    expected += within(t[0]) && within(t[1]) && within(t[2]) && within(t[3]) ? 1 : 0;
  ASSERT_GT(expected, 100u);
  EXPECT_EQ(part.mesh.tetrahedra.size(), expected);
  EXPECT_THAT(part.notes, testing::Contains(testing::HasSubstr("within the threshold")));

  scene.threshold = {3.0, 3.0};  // at one corner of the box: not at all points of any cell
  EXPECT_TRUE(prepared(scene).mesh.tetrahedra.empty());
}

TEST(ClipScene, ThresholdOfCellDataIsOfTheirOwnValues) {
  TetMesh mesh = box(true);
  auto& values = mesh.cellFields[0].values;
  values[3] = std::numeric_limits<double>::quiet_NaN();
  std::size_t expected = 0;
  for (const double v : values) expected += v >= 0 && v <= 1 ? 1 : 0;
  Scene scene;
  scene.threshold = {0.0, 1.0};
  const PreparedScene part = prepared(scene, mesh);
  EXPECT_EQ(part.mesh.tetrahedra.size(), expected);
  EXPECT_EQ(part.scalars.size(), expected);
}

TEST(ClipScene, MayLeaveNothing) {
  Scene scene;
  scene.clipPlanes = {{{2, 0, 0}, {1, 0, 0}}};
  const PreparedScene nothing = prepared(scene);
  EXPECT_TRUE(nothing.mesh.tetrahedra.empty());
  EXPECT_TRUE(nothing.points.empty());
  EXPECT_EQ(nothing.faces.size(), 0u);
  EXPECT_THAT(nothing.notes, testing::Contains(testing::HasSubstr("nothing of the mesh is left")));
  scene.clipPlanes = {};
  scene.clipBoxes = {{{-2, -2, -2}, {2, 2, 2}, false}};
  EXPECT_TRUE(prepared(scene).mesh.tetrahedra.empty());
}

TEST(ClipScene, RefusesWhatCannotBeMeant) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto refused = [](const Scene& scene, const std::string& why) {
    try {
      checkClipping(scene);
      ADD_FAILURE() << why;
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::input);
      EXPECT_THAT(error.what(), testing::HasSubstr(why));
    }
  };
  Scene scene;
  scene.clipPlanes = {{{0, nan, 0}, {1, 0, 0}}};
  refused(scene, "not finite");
  scene.clipPlanes = {{{0, 0, 0}, {0, 0, 0}}};
  refused(scene, "normal has no length");
  scene = {};
  scene.clipBoxes = {{{0, 0, 0}, {1, 0, 1}}};
  refused(scene, "--clip-box");
  scene.clipBoxes = {{{0, 0, 0}, {1, -1, 1}, false}};
  refused(scene, "--cut-box");
  scene = {};
  scene.threshold = {1.0, 0.0};
  refused(scene, "--threshold");
}

TEST(ClipScene, NormalsOfAnyLengthMeanTheSame) {
  Scene scene;
  scene.clipPlanes = {{{0.1, 0.2, 0.3}, {1, 2, -1}}};
  const std::vector<Vec3> points = prepared(scene).points;
  scene.clipPlanes[0].normal *= 0x1p-1000;
  EXPECT_EQ(prepared(scene).points, points);
  scene.clipPlanes[0].normal *= 0x1p1000;
  scene.clipPlanes[0].normal *= 0x1p1000;
  EXPECT_EQ(prepared(scene).points, points);
}

}  // namespace
}  // namespace havs
