// What is carried through the cut, what is left out, and what is refused.
#include "mesh/cells.h"

#include <gmock/gmock.h>

#include "unit/mesh/mesh_checks.h"

namespace havs {
namespace {
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

CellSoup unitCube() {
  CellSoup soup;
  soup.points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
  test::addCell(soup, 12, {0, 1, 2, 3, 4, 5, 6, 7});
  return soup;
}

TEST(Cells, TetrahedraAloneStayAsTheyAre) {
  CellSoup soup;
  soup.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}};
  soup.pointFields = {{"v", 2, {0, 1, 2, 3, 4, 5, 6, 7, 8, 9}}};
  soup.cellFields = {{"c", 1, {10, 20}}};
  soup.notes = {"read"};
  test::addCell(soup, 10, {3, 1, 2, 0});
  test::addCell(soup, 10, {1, 1, 2, 4});  // flat: a defect to be counted, not the cut's to drop
  const TetMesh mesh = cutIntoTetrahedra(soup, "test");
  EXPECT_THAT(mesh.tetrahedra, ElementsAre(Tetrahedron{3, 1, 2, 0}, Tetrahedron{1, 1, 2, 4}));
  EXPECT_EQ(mesh.pointFields[0].values, soup.pointFields[0].values);
  EXPECT_EQ(mesh.cellFields[0].values, soup.cellFields[0].values);
  EXPECT_THAT(mesh.notes, ElementsAre("read"));
  EXPECT_EQ(mesh.sourceCells, 2u);
}

TEST(Cells, CellDataGoToEveryPieceAndLowerCellsAreNoted) {
  CellSoup soup;
  soup.points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {.5, .5, 1}, {0, 0, -1}};
  test::addCell(soup, 5, {0, 1, 2});
  test::addCell(soup, 14, {0, 1, 2, 3, 4});
  test::addCell(soup, 3, {0, 1});
  test::addCell(soup, 10, {0, 2, 1, 5});
  test::addCell(soup, 5, {0, 2, 3});
  soup.cellFields = {{"id", 2, {0, 0, 1, -1, 2, 0, 3, -3, 4, 0}}};
  const TetMesh mesh = cutIntoTetrahedra(soup, "test");
  EXPECT_EQ(mesh.sourceCells, 2u);
  EXPECT_THAT(mesh.cellFields[0].values, ElementsAre(1, -1, 1, -1, 3, -3));
  EXPECT_THAT(mesh.notes, ElementsAre("left out cells that enclose no volume: 1 lines, 2 triangles"));
}

TEST(Cells, AddedCentresGetTheMeanOfThePointData) {
  CellSoup soup;
  soup.points = {{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0, 0, 2}};
  soup.pointFields = {{"v", 2, {0, 4, 1, 4, 2, 4, 5, 4}}};
  test::addCell(soup, 42, {4, 3, 0, 2, 1, 3, 0, 1, 3, 3, 1, 2, 3, 3, 0, 3, 2});
  const TetMesh mesh = cutIntoTetrahedra(soup, "test");
  ASSERT_EQ(mesh.points.size(), 5u);
  EXPECT_EQ(mesh.points[4], Vec3(0.5));
  EXPECT_DOUBLE_EQ(mesh.pointFields[0].values[8], 2);
  EXPECT_DOUBLE_EQ(mesh.pointFields[0].values[9], 4);
}

TEST(Cells, HexahedronCollapsedToAWedgeConformsWithATrueWedge) {
  // The cube halved at the square x = y: one half a wedge, the other a hexahedron that names two points twice.
  CellSoup soup = unitCube();
  soup.types.clear();
  soup.offsets.clear();
  soup.connectivity.clear();
  test::addCell(soup, 12, {0, 1, 2, 2, 4, 5, 6, 6});
  test::addCell(soup, 13, {0, 2, 3, 4, 6, 7});
  const TetMesh mesh = cutIntoTetrahedra(soup, "test");
  EXPECT_EQ(mesh.tetrahedra.size(), 6u);
  EXPECT_EQ(test::boundaryFaces(mesh), 12);
  EXPECT_NEAR(test::totalVolume(mesh), 1, 1e-15);
  EXPECT_GT(test::smallestVolume(mesh), 0);
  EXPECT_THAT(mesh.notes, ElementsAre(HasSubstr("1 cells name a point more than once")));
}

TEST(Cells, CellCollapsedToAFaceIsLeftOutAndNoted) {
  CellSoup soup = unitCube();
  test::addCell(soup, 13, {0, 1, 2, 0, 1, 2});
  const TetMesh mesh = cutIntoTetrahedra(soup, "test");
  EXPECT_NEAR(test::totalVolume(mesh), 1, 1e-15);
  EXPECT_THAT(mesh.notes, ElementsAre(HasSubstr("1 of them have no volume at all")));
}

std::string cutError(const CellSoup& soup) {
  return test::inputError([&] { cutIntoTetrahedra(soup, "mesh.vtu"); });
}

TEST(Cells, PointNumbersOutOfRangeNameTheCell) {
  CellSoup soup = unitCube();
  test::addCell(soup, 10, {0, 1, 2, 8});
  EXPECT_THAT(cutError(soup),
              AllOf(HasSubstr("mesh.vtu: cell 1 "), HasSubstr("point number 8"), HasSubstr("8 points")));
  soup.connectivity.back() = -1;
  EXPECT_THAT(cutError(soup), HasSubstr("point number -1"));
}

TEST(Cells, UnknownAndUnsupportedTypesAreRefused) {
  CellSoup soup = unitCube();
  test::addCell(soup, 99, {0, 1, 2, 3});
  EXPECT_THAT(cutError(soup), HasSubstr("cell 1 has the unknown type 99"));
  soup.types[1] = 71;
  EXPECT_THAT(cutError(soup), AllOf(HasSubstr("type 71 (Lagrange tetrahedra)"), HasSubstr("linear or quadratic")));
}

TEST(Cells, WrongNumbersOfPointsAreRefused) {
  CellSoup soup = unitCube();
  test::addCell(soup, 13, {0, 1, 2, 3, 4});
  EXPECT_THAT(cutError(soup), HasSubstr("cell 1 has 5 points, but wedges have 6"));
}

TEST(Cells, BrokenPolyhedraAreRefused) {
  const std::vector<std::vector<std::int64_t>> streams = {
      {},
      {3, 3, 0, 1, 2, 3, 0, 1, 3, 3, 1, 2, 3},                 // three faces
      {4, 3, 0, 2, 1, 3, 0, 1, 3, 3, 1, 2, 3, 3, 0, 3},        // cut short
      {4, 3, 0, 2, 1, 3, 0, 1, 3, 3, 1, 2, 3, 3, 0, 3, 2, 1},  // too long
      {4, 3, 0, 2, 1, 3, 0, 1, 3, 3, 1, 2, 3, 3, 0, 3, 9},     // point out of range
      {4, 2, 0, 2, 3, 0, 1, 3, 3, 1, 2, 3, 3, 0, 3, 2},        // a face of two points
      {4, std::int64_t{1} << 62, 0, 2, 1},                     // a promise
      {std::int64_t{1} << 40, 3, 0, 2, 1, 3, 0, 1, 3, 3, 1, 2, 3, 3, 0, 3, 2}};
  for (const auto& stream : streams) {
    CellSoup soup = unitCube();
    test::addCell(soup, 42, stream);
    EXPECT_THAT(cutError(soup), HasSubstr("cell 1 is a polyhedron whose list of faces is broken"));
  }
}

TEST(Cells, ArraysThatDoNotFitAreRefused) {
  CellSoup soup = unitCube();
  soup.pointFields = {{"p", 1, {1, 2, 3}}};
  EXPECT_THAT(cutError(soup), HasSubstr("'p' has 3 values of 1 components for 8 points"));
  soup = unitCube();
  soup.cellFields = {{"c", 3, {1, 2}}};
  EXPECT_THAT(cutError(soup), HasSubstr("for 1 cells"));
  soup = unitCube();
  soup.offsets.back() = 9;
  EXPECT_THAT(cutError(soup), HasSubstr("do not fit"));
  soup = unitCube();
  test::addCell(soup, 10, {0, 1, 2, 3});
  soup.offsets[1] = 13;
  EXPECT_THAT(cutError(soup), HasSubstr("cell 1 ends before it begins"));
}

TEST(Cells, MeshesWithoutVolumeAreRefused) {
  CellSoup soup = unitCube();
  soup.types[0] = 7;
  EXPECT_THAT(cutError(soup), HasSubstr("no solid cells"));
  EXPECT_THAT(cutError(CellSoup{{{0, 0, 0}}}), HasSubstr("no cells"));
  soup = unitCube();
  soup.connectivity.assign(8, 1);
  EXPECT_THAT(cutError(soup), HasSubstr("no cell encloses a volume"));
}

}  // namespace
}  // namespace havs
