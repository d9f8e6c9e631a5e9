#include "mesh/defects.h"

#include <gmock/gmock.h>

#include <limits>

#include "core/parallel.h"
#include "mesh/cells.h"
#include "unit/mesh/mesh_checks.h"

namespace havs {
namespace {
using testing::ElementsAre;
using testing::HasSubstr;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

/// 3 x 3 x 3 cells of five sound tetrahedra, a point field and a cell field of the numbers.
TetMesh soundMesh() {
  std::vector<Vec3> points;
  Field number{"number", 1, {}};
  for (int i = 0; i < 64; ++i) {
    points.emplace_back(i % 4, i / 4 % 4, i / 16);
    number.values.push_back(i);
  }
  TetMesh mesh = cutStructuredGrid({4, 4, 4}, points, {}, {number}, {}, "test");
  Field cell{"cell", 1, {}};
  for (std::size_t i = 0; i < mesh.tetrahedra.size(); ++i) cell.values.push_back(static_cast<double>(i));
  mesh.cellFields.push_back(cell);
  return mesh;
}

Defect defect(const TetMesh& mesh, const std::string& name) {
  for (const Defect& found : inspectMesh(mesh))
    if (found.name == name) return found;
  ADD_FAILURE() << "no row " << name;
  return {};
}

/// Checks that of all kinds of defect the mesh has only this one.
void expectOnly(const TetMesh& mesh, const std::string& name, std::size_t count, std::size_t first) {
  for (const Defect& found : inspectMesh(mesh)) {
    EXPECT_EQ(found.count, found.name == name ? count : 0) << found.name;
    if (found.name == name && count > 0) {
      EXPECT_EQ(found.first, first) << found.name;
    }
    EXPECT_FALSE(found.repair.empty());
  }
}

TEST(Defects, SoundMeshHasEveryRowWithNone) {
  const TetMesh mesh = soundMesh();
  std::vector<std::string> names;
  for (const Defect& found : inspectMesh(mesh)) names.push_back(found.name);
  EXPECT_THAT(names,
              ElementsAre("inverted_cells", "flat_cells", "duplicate_cells", "overfull_faces", "overlapping_cells",
                          "unreferenced_points", "non_finite_points", "non_finite_scalars"));
  expectOnly(mesh, "", 0, 0);
  const TetMesh same = repairMesh(mesh);
  EXPECT_EQ(same.tetrahedra, mesh.tetrahedra);
  EXPECT_EQ(same.points, mesh.points);
  EXPECT_THAT(same.notes, testing::IsEmpty());
}

TEST(Defects, InvertedCellsAreTurned) {
  TetMesh mesh = soundMesh();
  for (const std::size_t cell : {17u, 40u, 99u}) std::swap(mesh.tetrahedra[cell][0], mesh.tetrahedra[cell][1]);
  expectOnly(mesh, "inverted_cells", 3, 17);
  const TetMesh mended = repairMesh(mesh);
  expectOnly(mended, "", 0, 0);
  EXPECT_EQ(mended.tetrahedra.size(), mesh.tetrahedra.size());
  EXPECT_THAT(mended.notes, ElementsAre("3 inverted cells were turned"));
}

TEST(Defects, FlatCellsAreLeftOutWithTheirData) {
  TetMesh mesh = soundMesh();
  mesh.tetrahedra[5] = {0, 1, 5, 4};     // four points of a plane
  mesh.tetrahedra[20] = {7, 7, 10, 20};  // a point twice
  EXPECT_EQ(defect(mesh, "flat_cells").count, 2u);
  EXPECT_EQ(defect(mesh, "flat_cells").first, 5u);
  const TetMesh mended = repairMesh(mesh);
  EXPECT_EQ(mended.tetrahedra.size(), 133u);
  EXPECT_EQ(mended.cellFields[0].values.size(), 133u);
  EXPECT_EQ(mended.cellFields[0].values[5], 6);
  EXPECT_EQ(mended.cellFields[0].values[19], 21);
}

TEST(Defects, FlatIsMeasuredByTheLongestEdgeAtAnyScale) {
  for (const double scale : {1e-300, 1e-150, 1.0, 1e150, 1e300})
    for (const auto& [height, name] : {std::pair(1e-13, ""), std::pair(1e-16, "flat_cells")}) {
      TetMesh mesh;
      mesh.points = {Vec3(0, 0, 0), Vec3(scale, 0, 0), Vec3(0, scale, 0), Vec3(0, 0, scale * height)};
      mesh.tetrahedra = {{0, 1, 2, 3}};
      expectOnly(mesh, name, 1, 0);
    }
}

TEST(Defects, DuplicateCellsTheFirstStays) {
  TetMesh mesh = soundMesh();
  const Tetrahedron t = mesh.tetrahedra[3];
  mesh.tetrahedra.insert(mesh.tetrahedra.end(), {{t[1], t[2], t[0], t[3]}, {t[2], t[0], t[1], t[3]}});
  mesh.cellFields[0].values.insert(mesh.cellFields[0].values.end(), {1000, 2000});
  EXPECT_EQ(defect(mesh, "duplicate_cells").count, 2u);
  EXPECT_EQ(defect(mesh, "duplicate_cells").first, 135u);
  const TetMesh mended = repairMesh(mesh);
  EXPECT_EQ(mended.tetrahedra.size(), 135u);
  EXPECT_EQ(mended.tetrahedra[3], t);
  EXPECT_EQ(mended.cellFields[0].values.back(), 134);
  expectOnly(mended, "", 0, 0);
}

TEST(Defects, OverfullFacesAreCountedOnceEach) {
  TetMesh mesh;
  mesh.points = {{0, 0, 0},  {1, 0, 0}, {0, 1, 0},  {0, 0, 1},  {0, 0, 2},
                 {0, 0, -1}, {9, 9, 9}, {9, 9, 10}, {9, 10, 9}, {10, 9, 9}};
  mesh.tetrahedra = {{6, 9, 8, 7}, {0, 1, 2, 3}, {0, 1, 2, 4}, {0, 2, 1, 5}};
  EXPECT_EQ(defect(mesh, "overfull_faces").count, 1u);
  EXPECT_EQ(defect(mesh, "overfull_faces").first, 1u);
  EXPECT_EQ(defect(mesh, "overlapping_cells").count, 2u);  // two of the three are on one side
  EXPECT_EQ(defect(mesh, "overlapping_cells").first, 1u);
  EXPECT_EQ(repairMesh(mesh).tetrahedra.size(), 4u);
}

TEST(Defects, UnreferencedPointsAreLeftOutWithTheirData) {
  TetMesh mesh = soundMesh();
  mesh.points.insert(mesh.points.begin(), Vec3(7));
  mesh.pointFields[0].values.insert(mesh.pointFields[0].values.begin(), -1);
  for (Tetrahedron& t : mesh.tetrahedra)
    for (Index& point : t) ++point;
  mesh.points.emplace_back(8);
  mesh.pointFields[0].values.push_back(-2);
  expectOnly(mesh, "unreferenced_points", 2, 0);
  const TetMesh mended = repairMesh(mesh);
  EXPECT_EQ(mended.points, soundMesh().points);
  EXPECT_EQ(mended.tetrahedra, soundMesh().tetrahedra);
  EXPECT_EQ(mended.pointFields[0].values, soundMesh().pointFields[0].values);
}

TEST(Defects, CellsWithNonFinitePointsAreLeftOut) {
  TetMesh mesh = soundMesh();
  mesh.points[0].y = kNan;  // a corner: one tetrahedron
  mesh.points[63].z = std::numeric_limits<double>::infinity();
  expectOnly(mesh, "non_finite_points", 2, 0);
  const TetMesh mended = repairMesh(mesh);
  EXPECT_LT(mended.tetrahedra.size(), 135u);
  EXPECT_EQ(mended.points.size(), 62u);
  expectOnly(mended, "", 0, 0);
}

TEST(Defects, NonFiniteScalarsAreCountedAndStay) {
  TetMesh mesh = soundMesh();
  mesh.pointFields.push_back({"v", 3, std::vector<double>(192, 1.0)});
  mesh.pointFields[1].values[3 * 9 + 2] = kNan;
  mesh.pointFields[1].values[3 * 9 + 1] = kNan;
  mesh.pointFields[0].values[30] = -std::numeric_limits<double>::infinity();
  mesh.cellFields[0].values[4] = kNan;
  expectOnly(mesh, "non_finite_scalars", 3, 9);  // two points and a cell
  EXPECT_EQ(repairMesh(mesh).tetrahedra.size(), 135u);
}

TEST(Defects, MeshOfNothingButFlatCellsIsRefused) {
  TetMesh mesh;
  mesh.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
  mesh.tetrahedra = {{0, 1, 2, 3}};
  EXPECT_THAT(test::inputError([&] { repairMesh(mesh); }), HasSubstr("none of the 1 cells"));
}

TEST(Defects, CountsDoNotDependOnTheNumberOfThreads) {
  TetMesh mesh = soundMesh();
  const std::vector<Tetrahedron> once = mesh.tetrahedra;
  for (int i = 0; i < 200; ++i) mesh.tetrahedra.insert(mesh.tetrahedra.end(), once.begin(), once.end());
  mesh.cellFields.clear();
  const auto counts = [&] {
    std::vector<std::size_t> all;
    for (const Defect& found : inspectMesh(mesh)) all.insert(all.end(), {found.count, found.first});
    return all;
  };
  const auto many = counts();
  const ThreadLimit one(1);
  EXPECT_EQ(counts(), many);
  EXPECT_EQ(many[4], once.size() * 200);
  EXPECT_EQ(many[5], once.size());
}

TEST(Weld, MergesPointsOfTheSamePlaceAndData) {
  TetMesh mesh;
  mesh.points = {{0, 0, 0}, {1, 0, 0}, {-0.0, 0, -0.0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 0}, {1, 0, 0}};
  mesh.pointFields = {{"v", 2, {0, 1, 2, 3, 0, 1, 4, 5, 6, 7, 2, 3, 2, 9}}};  // the last differs in its data
  mesh.tetrahedra = {{2, 5, 3, 4}, {0, 1, 3, 6}};
  EXPECT_EQ(weldPoints(mesh), 2u);
  EXPECT_THAT(mesh.points, ElementsAre(Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1), Vec3(1, 0, 0)));
  EXPECT_THAT(mesh.tetrahedra, ElementsAre(Tetrahedron{0, 1, 2, 3}, Tetrahedron{0, 1, 2, 4}));
  EXPECT_THAT(mesh.pointFields[0].values, ElementsAre(0, 1, 2, 3, 4, 5, 6, 7, 2, 9));
  EXPECT_EQ(weldPoints(mesh), 0u);
}

}  // namespace
}  // namespace havs
