// Every type of cell on its own: the pieces fill it, none overlaps, none is turned. The positions are VTK's parametric
// coordinates of the types, written down apart from the tables of the cutter.
#include <gmock/gmock.h>

#include <random>

#include "mesh/cells.h"
#include "unit/mesh/mesh_checks.h"

namespace havs {
namespace {

constexpr double h = 0.5;
const std::vector<Vec3> kHexahedron = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},
                                       {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
const std::vector<Vec3> kHexahedronEdges = {{h, 0, 0}, {1, h, 0}, {h, 1, 0}, {0, h, 0}, {h, 0, 1}, {1, h, 1},
                                            {h, 1, 1}, {0, h, 1}, {0, 0, h}, {1, 0, h}, {1, 1, h}, {0, 1, h}};
const std::vector<Vec3> kHexahedronSides = {{0, h, h}, {1, h, h}, {h, 0, h}, {h, 1, h}};
const std::vector<Vec3> kWedge = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {0, 1, 1}};
const std::vector<Vec3> kWedgeEnds = {{h, 0, 0}, {h, h, 0}, {0, h, 0}, {h, 0, 1}, {h, h, 1}, {0, h, 1}};
const std::vector<Vec3> kWedgeUprights = {{0, 0, h}, {1, 0, h}, {0, 1, h}};
const std::vector<Vec3> kPyramid = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {h, h, 1}};
const std::vector<Vec3> kPyramidEdges = {{h, 0, 0},     {1, h, 0},     {h, 1, 0},     {0, h, 0},
                                         {.25, .25, h}, {.75, .25, h}, {.75, .75, h}, {.25, .75, h}};

std::vector<Vec3> joined(std::initializer_list<std::vector<Vec3>> parts) {
  std::vector<Vec3> all;
  for (const auto& part : parts) all.insert(all.end(), part.begin(), part.end());
  return all;
}

std::vector<Vec3> regularPrism(int n) {
  std::vector<Vec3> points;
  for (int z = 0; z < 2; ++z)
    for (int i = 0; i < n; ++i) points.emplace_back(std::cos(2 * M_PI * i / n), std::sin(2 * M_PI * i / n), z);
  return points;
}
double regularArea(int n) { return 0.5 * n * std::sin(2 * M_PI / n); }

struct CellType {
  const char* name;
  std::uint8_t type;
  std::vector<Vec3> points;
  double volume;
  std::vector<std::size_t> pieces;  ///< the numbers of tetrahedra that may come out
  int surface;                      ///< triangles on the surface
};

const std::vector<CellType>& cellTypes() {
  static const double third = 1.0 / 3;
  static const std::vector<CellType> types = {
      {"Tetra", 10, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, third / 2, {1}, 4},
      {"Voxel",
       11,
       {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {1, 1, 1}},
       1,
       {5, 6},
       12},
      {"Hexahedron", 12, kHexahedron, 1, {5, 6}, 12},
      {"Wedge", 13, kWedge, 0.5, {3}, 8},
      {"Pyramid", 14, kPyramid, third, {2}, 6},
      {"PentagonalPrism", 15, regularPrism(5), regularArea(5), {9}, 16},
      {"HexagonalPrism", 16, regularPrism(6), regularArea(6), {12}, 20},
      {"QuadraticTetra",
       24,
       {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {h, 0, 0}, {h, h, 0}, {0, h, 0}, {0, 0, h}, {h, 0, h}, {0, h, h}},
       third / 2,
       {8},
       16},
      {"QuadraticHexahedron", 25, joined({kHexahedron, kHexahedronEdges}), 1, {36}, 36},
      {"QuadraticWedge", 26, joined({kWedge, kWedgeEnds, kWedgeUprights}), 0.5, {26}, 26},
      {"QuadraticPyramid", 27, joined({kPyramid, kPyramidEdges}), third, {22}, 22},
      {"TriquadraticHexahedron",
       29,
       joined({kHexahedron, kHexahedronEdges, kHexahedronSides, {{h, h, 0}, {h, h, 1}, {h, h, h}}}),
       1,
       {48},
       48},
      {"QuadraticLinearWedge", 31, joined({kWedge, kWedgeEnds}), 0.5, {20}, 20},
      {"BiquadraticQuadraticWedge",
       32,
       joined({kWedge, kWedgeEnds, kWedgeUprights, {{h, 0, h}, {h, h, h}, {0, h, h}}}),
       0.5,
       {32},
       32},
      {"BiquadraticQuadraticHexahedron", 33, joined({kHexahedron, kHexahedronEdges, kHexahedronSides}), 1, {44}, 44},
      {"TriquadraticPyramid",
       37,
       joined({kPyramid,
               kPyramidEdges,
               {{h, h, 0},
                {h, third / 2, third},
                {1 - third / 2, h, third},
                {h, 1 - third / 2, third},
                {third / 2, h, third},
                {h, h, .25}}}),
       third,
       {32},
       32},
  };
  return types;
}

class CellTypes : public testing::TestWithParam<CellType> {};

TEST_P(CellTypes, PiecesFillTheCellUnderAnyNumbering) {
  const CellType& cell = GetParam();
  std::mt19937 random(1);
  for (int trial = 0; trial < 60; ++trial) {
    std::vector<std::int64_t> numbers(cell.points.size());
    for (std::size_t i = 0; i < numbers.size(); ++i) numbers[i] = static_cast<std::int64_t>(i);
    if (trial > 0) std::shuffle(numbers.begin(), numbers.end(), random);
    CellSoup soup;
    soup.points.resize(cell.points.size());
    for (std::size_t i = 0; i < numbers.size(); ++i) soup.points[static_cast<std::size_t>(numbers[i])] = cell.points[i];
    test::addCell(soup, cell.type, numbers);
    const TetMesh mesh = cutIntoTetrahedra(soup, "test");

    EXPECT_THAT(cell.pieces, testing::Contains(mesh.tetrahedra.size()));
    EXPECT_EQ(test::boundaryFaces(mesh), cell.surface);
    EXPECT_NEAR(test::totalVolume(mesh), cell.volume, 1e-14);  // a few tens of roundings of 1e-16
    EXPECT_GT(test::smallestVolume(mesh), 1e-3);               // the smallest piece of any type has 1/192
    EXPECT_EQ(mesh.sourceCells, 1u);
    EXPECT_THAT(mesh.notes, testing::IsEmpty());
  }
}

INSTANTIATE_TEST_SUITE_P(All, CellTypes, testing::ValuesIn(cellTypes()),
                         [](const auto& test) { return std::string(test.param.name); });

TEST(CellTypes, HexahedraComeInFiveAndInSix) {
  std::mt19937 random(2);
  std::map<std::size_t, int> seen;
  std::vector<std::int64_t> numbers = {0, 1, 2, 3, 4, 5, 6, 7};
  for (int trial = 0; trial < 200; ++trial) {
    std::shuffle(numbers.begin(), numbers.end(), random);
    CellSoup soup;
    soup.points = kHexahedron;
    for (std::size_t i = 0; i < 8; ++i) soup.points[static_cast<std::size_t>(numbers[i])] = kHexahedron[i];
    test::addCell(soup, 12, numbers);
    ++seen[cutIntoTetrahedra(soup, "test").tetrahedra.size()];
  }
  // No diagonal ends opposite to the lowest number: about one numbering in ten.
  EXPECT_GT(seen[5], 3);
  EXPECT_GT(seen[6], 100);
  EXPECT_EQ(seen.size(), 2u);
}

TEST(CellTypes, PolyhedronOfUnorderedFacesIsConedFromItsCentre) {
  CellSoup soup;
  soup.points = kHexahedron;
  soup.pointFields = {{"x", 1, {0, 1, 1, 0, 0, 1, 1, 0}}};
  // A cube whose faces are turned inward and outward by turns.
  test::addCell(soup, 42,
                {6, 4, 0, 1, 2, 3, 4, 4, 5, 6, 7, 4, 0, 1, 5, 4, 4, 2, 6, 7, 3, 4, 0, 4, 7, 3, 4, 1, 5, 6, 2});
  const TetMesh mesh = cutIntoTetrahedra(soup, "test");
  EXPECT_EQ(mesh.tetrahedra.size(), 12u);
  EXPECT_EQ(test::boundaryFaces(mesh), 12);
  EXPECT_NEAR(test::totalVolume(mesh), 1, 1e-14);
  EXPECT_GT(test::smallestVolume(mesh), 0);
  ASSERT_EQ(mesh.points.size(), 9u);
  EXPECT_EQ(mesh.points[8], Vec3(0.5));
  EXPECT_DOUBLE_EQ(mesh.pointFields[0].values[8], 0.5);
}

}  // namespace
}  // namespace havs
