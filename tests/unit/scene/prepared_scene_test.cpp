// A mesh without defects goes a shorter way than one that is mended: both lead to the same.
#include "scene/prepared_scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "support/meshes.h"

namespace havs {
namespace {

/// A jittered box with a field at the points and one at the cells.
TetMesh fieldedBox() {
  TetMesh mesh = test::box(6, test::Cut::five, 0.2);
  mesh.pointFields.push_back({"p", 1, test::pointValues(mesh.points, [](const Vec3& p) { return p.x + 2 * p.y; })});
  Field cells{"c", 1, {}};
  for (std::size_t i = 0; i < mesh.tetrahedra.size(); ++i) cells.values.push_back(static_cast<double>(i % 17));
  mesh.cellFields.push_back(cells);
  return mesh;
}

PreparedScene prepared(TetMesh mesh, const std::string& field) {
  Scene scene;
  scene.field = field;
  StageTimes stages;
  PreparedScene result = prepareScene(scene, std::move(mesh), stages);
  EXPECT_EQ(stages.medians().size(), 2u);
  return result;
}

std::size_t countOf(const PreparedScene& scene, const std::string& defect) {
  const auto row =
      std::find_if(scene.defects.begin(), scene.defects.end(), [&](const Defect& d) { return d.name == defect; });
  return row == scene.defects.end() ? 999 : row->count;
}

void expectSame(const PreparedScene& a, const PreparedScene& b) {
  EXPECT_EQ(a.points, b.points);
  EXPECT_EQ(a.mesh.points, b.mesh.points);
  EXPECT_EQ(a.mesh.tetrahedra, b.mesh.tetrahedra);
  EXPECT_EQ(a.scalars, b.scalars);
  EXPECT_EQ(a.faces.vertices, b.faces.vertices);
  EXPECT_EQ(a.faces.cells, b.faces.cells);
  EXPECT_EQ(a.faces.ofCell, b.faces.ofCell);
  EXPECT_EQ(a.field.minimum, b.field.minimum);
  EXPECT_EQ(a.field.maximum, b.field.maximum);
  EXPECT_EQ(a.longestEdge, b.longestEdge);
  EXPECT_EQ(a.defects.size(), b.defects.size());
}

TEST(PreparedScene, IsTheSameWithAndWithoutSomethingToMend) {
  for (const std::string field : {"p", "c"}) {
    TetMesh spare = fieldedBox();
    spare.points.emplace_back(0.1, 0.2, 0.3);
    spare.pointFields[0].values.push_back(1e9);
    const PreparedScene sound = prepared(fieldedBox(), field), mended = prepared(spare, field);
    expectSame(sound, mended);
    EXPECT_EQ(countOf(sound, "unreferenced_points"), 0u);
    EXPECT_EQ(countOf(mended, "unreferenced_points"), 1u);
    EXPECT_TRUE(sound.notes.empty());
  }
}

TEST(PreparedScene, FindsDuplicateCellsThatOnlyTheirFacesShow) {
  TetMesh twice = fieldedBox();
  twice.tetrahedra.push_back(twice.tetrahedra[40]);
  twice.cellFields[0].values.push_back(3);
  const PreparedScene mended = prepared(twice, "c");
  EXPECT_EQ(countOf(mended, "duplicate_cells"), 1u);
  EXPECT_GE(countOf(mended, "overfull_faces"), 1u);
  PreparedScene sound = prepared(fieldedBox(), "c");
  EXPECT_EQ(sound.mesh.tetrahedra, mended.mesh.tetrahedra);
  EXPECT_EQ(sound.scalars, mended.scalars);
}

// Every scalar stays with its place.
TEST(PreparedScene, ScalarsFollowTheirPointsAndCells) {
  const TetMesh mesh = fieldedBox();
  const PreparedScene points = prepared(mesh, "p"), cells = prepared(mesh, "c");
  for (std::size_t i = 0; i < points.points.size(); ++i) {
    const Vec3& p = points.mesh.points[i];
    EXPECT_NEAR(points.scalars[i], (p.x + 2 * p.y + 3) / 6, 1e-15);
  }
  const auto cellAt = [&](const std::array<Vec3, 4>& corners) {
    for (std::size_t c = 0; c < mesh.tetrahedra.size(); ++c) {
      const Tetrahedron& t = mesh.tetrahedra[c];
      if (corners == std::array{mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]], mesh.points[t[3]]}) return c;
    }
    return mesh.tetrahedra.size();
  };
  for (std::size_t c = 0; c < cells.mesh.tetrahedra.size(); c += 13) {
    const Tetrahedron& t = cells.mesh.tetrahedra[c];
    const auto& p = cells.mesh.points;
    const std::size_t file = cellAt({p[t[0]], p[t[1]], p[t[2]], p[t[3]]});
    ASSERT_LT(file, mesh.tetrahedra.size());
    EXPECT_DOUBLE_EQ(cells.scalars[c], static_cast<double>(file % 17) / 16);
  }
}

TEST(PreparedScene, HolesHaveBoundariesOfTheirOwn) {
  TetMesh mesh = fieldedBox();
  mesh.cellFields[0].values[200] = std::numeric_limits<double>::quiet_NaN();
  const PreparedScene whole = prepared(fieldedBox(), "c"), holed = prepared(mesh, "c");
  EXPECT_EQ(holed.mesh.tetrahedra.size() + 1, whole.mesh.tetrahedra.size());
  EXPECT_EQ(holed.faces.ofCell.size(), holed.mesh.tetrahedra.size());
  EXPECT_EQ(2 * holed.faces.size() - holed.faces.boundaryCount, 4 * holed.mesh.tetrahedra.size());
  EXPECT_EQ(countOf(holed, "non_finite_scalars"), 1u);
  EXPECT_EQ(holed.notes.size(), 2u);  // the defect and the hole
}

}  // namespace
}  // namespace havs
