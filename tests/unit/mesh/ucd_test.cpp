#include <gmock/gmock.h>

#include "mesh/defects.h"
#include "mesh/read.h"
#include "mesh/scalar_field.h"
#include "unit/mesh/mesh_checks.h"

namespace havs {
namespace {
using testing::ElementsAre;
using testing::HasSubstr;

// A cube cut in a hexahedron's, a prism's and a pyramid's way side by side, top first as AVS numbers them.
const char* const kMixed =
    "# a comment\n"
    "13 6 3 1 0\n"
    "10 0 0 1\n20 1 0 1\n30 1 1 1\n40 0 1 1\n50 0 0 0\n60 1 0 0\n70 1 1 0\n80 0 1 0\n"  // the cube
    "90 2 0 1\n100 2 0 0\n"                                                             // a prism beside it
    "110 .5 .5 3\n"                                                                     // a pyramid's tip above it
    "-5 0 2 0\n7 5 5 5\n"
    "1 1 hex 10 20 30 40 50 60 70 80\n"
    "2 2 prism 20 90 30 60 100 70\n"
    "3 1 pyr 110 10 20 30 40\n"
    "4 1 tet 80 70 -5 40\n"
    "5 1 tri 10 20 30\n"
    "6 1 quad 10 20 30 40\n"
    "2 1 2\nstress, lb/in**2\nflow rate\n"
    "10 1 0 1\n20 2 0 1\n30 3 0 1\n40 4 0 1\n50 5 0 1\n60 6 0 1\n70 7 0 1\n80 8 0 1\n90 9 0 1\n"
    "7 13 1 13\n100 10 0 1\n110 11 0 1\n-5 12 0 1\n"  // not in order
    "1 1\n, \n6 60\n5 50\n4 40\n3 30\n2 20\n1 10\n";

TEST(Ucd, MixedCellsNumbersOfAnyKindPointAndCellData) {
  const test::TemporaryFolder folder;
  const TetMesh mesh = readMesh(folder.write("m.inp", kMixed));
  EXPECT_EQ(mesh.points.size(), 13u);
  EXPECT_EQ(mesh.sourceCells, 4u);
  EXPECT_NEAR(test::totalVolume(mesh), 1 + 0.5 + 2.0 / 3 + 1.0 / 6, 1e-14);
  EXPECT_GT(test::smallestVolume(mesh), 0);
  ASSERT_EQ(mesh.pointFields.size(), 2u);
  EXPECT_EQ(mesh.pointFields[0].name, "stress");
  EXPECT_THAT(mesh.pointFields[0].values, ElementsAre(1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13));
  EXPECT_EQ(mesh.pointFields[1].name, "flow rate");
  EXPECT_EQ(mesh.pointFields[1].components, 2);
  EXPECT_EQ(mesh.pointFields[1].values[25], 13);
  ASSERT_EQ(mesh.cellFields.size(), 2u);
  EXPECT_EQ(mesh.cellFields[0].name, "data0");
  EXPECT_EQ(mesh.cellFields[0].values.front(), 10);
  EXPECT_EQ(mesh.cellFields[0].values.back(), 40);
  EXPECT_EQ(mesh.cellFields[1].name, "material");
  EXPECT_THAT(mesh.notes, ElementsAre(HasSubstr("1 triangles, 1 quadrilaterals")));
}

TEST(Ucd, MaterialMayBeLeftOut) {
  const test::TemporaryFolder folder;
  const TetMesh mesh =
      readMesh(folder.write("m.inp", "4 1 0 0 0\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n1 tet 1 2 3 4\n"));
  EXPECT_THAT(mesh.tetrahedra, ElementsAre(Tetrahedron{0, 1, 2, 3}));
  EXPECT_THAT(mesh.cellFields, testing::IsEmpty());
}

TEST(Ucd, SpxWithItsLabelWithoutAUnit) {
  const std::filesystem::path file = std::filesystem::path(HAVS_SHARED_DATA) / "spx.inp";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << "no " << file;
  TetMesh mesh = readMesh(file);
  EXPECT_EQ(mesh.points.size(), 2896u);
  EXPECT_EQ(mesh.tetrahedra.size(), 12936u);
  const ScalarField density = selectField(mesh, "");
  EXPECT_EQ(density.name, "density");
  EXPECT_EQ(density.minimum, 0.2);
  EXPECT_EQ(density.maximum, 1.0);
  const std::vector<Defect> defects = inspectMesh(mesh);
  EXPECT_GT(defects[0].count, 12000u);  // "nearly all cells inverted, one flat"
  EXPECT_EQ(defects[1].count, 1u);
  EXPECT_EQ(defects[1].first, 0u);
  mesh = repairMesh(std::move(mesh));
  EXPECT_EQ(mesh.tetrahedra.size(), 12935u);
  EXPECT_GT(test::smallestVolume(mesh), 0);
}

}  // namespace
}  // namespace havs
