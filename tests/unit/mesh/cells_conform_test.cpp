// Meshes of mixed cells: each inner face must be shared by exactly two tetrahedra, whatever the numbers of the points.
#include <gmock/gmock.h>

#include <functional>
#include <random>

#include "mesh/cells.h"
#include "unit/mesh/mesh_checks.h"

namespace havs {
namespace {

constexpr int kSize = 5;  // cells each way

/// A lattice of points in a cube of side n, numbered at random, the inner ones moved about a little.
class Lattice {
 public:
  Lattice(int n, double jitter, unsigned seed) : n_(n), random_(seed) {
    const int side = n + 1;
    numbers_.resize(static_cast<std::size_t>(side * side * side));
    for (std::size_t i = 0; i < numbers_.size(); ++i) numbers_[i] = static_cast<std::int64_t>(i);
    std::shuffle(numbers_.begin(), numbers_.end(), random_);
    soup.points.resize(numbers_.size());
    std::uniform_real_distribution<double> shift(-jitter, jitter);
    for (int k = 0; k < side; ++k)
      for (int j = 0; j < side; ++j)
        for (int i = 0; i < side; ++i) {
          const auto inner = [&](int a) { return a > 0 && a < n ? shift(random_) : 0.0; };
          const Vec3 moved(i + inner(i), j + inner(j), k + inner(k));
          soup.points[static_cast<std::size_t>(at(i, j, k))] = moved;
        }
  }
  std::int64_t at(int i, int j, int k) const {
    return numbers_[static_cast<std::size_t>(i + (n_ + 1) * (j + (n_ + 1) * k))];
  }
  /// The corners of the cell at (i, j, k) of the given size, in the order of a hexahedron.
  std::array<std::int64_t, 8> corners(int i, int j, int k, int size = 1) const {
    const int a = i + size, b = j + size, c = k + size;
    return {at(i, j, k), at(a, j, k), at(a, b, k), at(i, b, k), at(i, j, c), at(a, j, c), at(a, b, c), at(i, b, c)};
  }
  int pick(int choices) { return static_cast<int>(random_() % static_cast<unsigned>(choices)); }

  CellSoup soup;

 private:
  int n_;
  std::mt19937 random_;
  std::vector<std::int64_t> numbers_;
};

void addVoxel(CellSoup& soup, const std::array<std::int64_t, 8>& c) {
  test::addCell(soup, 11, {c[0], c[1], c[3], c[2], c[4], c[5], c[7], c[6]});
}
void addPolyhedron(CellSoup& soup, const std::array<std::int64_t, 8>& c) {
  test::addCell(soup, 42, {6, 4,    c[0], c[3], c[2], c[1], 4,    c[4], c[5], c[6], c[7], 4,    c[0], c[1], c[5], c[4],
                           4, c[3], c[2], c[6], c[7], 4,    c[0], c[4], c[7], c[3], 4,    c[1], c[2], c[6], c[5]});
}
void addSixPyramids(CellSoup& soup, const std::array<std::int64_t, 8>& c) {
  Vec3 centre(0);
  for (const auto corner : c) centre += soup.points[static_cast<std::size_t>(corner)] / 8.0;
  const auto apex = static_cast<std::int64_t>(soup.points.size());
  soup.points.push_back(centre);
  constexpr std::array<std::array<std::size_t, 4>, 6> kInward = {
      {{0, 1, 2, 3}, {4, 7, 6, 5}, {0, 4, 5, 1}, {3, 2, 6, 7}, {0, 3, 7, 4}, {1, 5, 6, 2}}};
  for (const auto& face : kInward) test::addCell(soup, 14, {c[face[0]], c[face[1]], c[face[2]], c[face[3]], apex});
}
void addTwoWedges(CellSoup& soup, const std::array<std::int64_t, 8>& c, bool otherDiagonal) {
  if (otherDiagonal) {
    test::addCell(soup, 13, {c[0], c[1], c[3], c[4], c[5], c[7]});
    test::addCell(soup, 13, {c[1], c[2], c[3], c[5], c[6], c[7]});
  } else {
    test::addCell(soup, 13, {c[0], c[1], c[2], c[4], c[5], c[6]});
    test::addCell(soup, 13, {c[0], c[2], c[3], c[4], c[6], c[7]});
  }
}

/// Upright columns of wedges (their triangles meet above and below) among boxes of every other kind.
void fillWithMixedCells(Lattice& lattice) {
  for (int j = 0; j < kSize; ++j)
    for (int i = 0; i < kSize; ++i) {
      const int column = lattice.pick(4);
      for (int k = 0; k < kSize; ++k) {
        const auto corners = lattice.corners(i, j, k);
        if (column < 2) {
          addTwoWedges(lattice.soup, corners, column == 1);
          continue;
        }
        const std::array<std::function<void()>, 4> add = {
            [&] {
              test::addCell(lattice.soup, 12, {corners.begin(), corners.end()});
            },
            [&] { addVoxel(lattice.soup, corners); }, [&] { addSixPyramids(lattice.soup, corners); },
            [&] { addPolyhedron(lattice.soup, corners); }};
        add[static_cast<std::size_t>(lattice.pick(4))]();
      }
    }
}

class MixedCells : public testing::TestWithParam<unsigned> {};

TEST_P(MixedCells, ConformAndFillTheWhole) {
  Lattice lattice(kSize, 0.1, GetParam());
  fillWithMixedCells(lattice);
  const TetMesh mesh = cutIntoTetrahedra(lattice.soup, "test");
  // Two triangles for each square of the six sides of the cube, and no face of one tetrahedron elsewhere.
  EXPECT_EQ(test::boundaryFaces(mesh), 2 * 6 * kSize * kSize);
  EXPECT_GT(test::smallestVolume(mesh), 0);
  EXPECT_NEAR(test::totalVolume(mesh), kSize * kSize * kSize, 1e-11);  // a thousand pieces' roundings
  EXPECT_EQ(mesh.sourceCells, lattice.soup.types.size());
}
INSTANTIATE_TEST_SUITE_P(Seeds, MixedCells, testing::Range(1u, 9u));

/// The 27 points of a cell two lattice steps wide, at (x, y, z) each 0, 1 or 2.
std::int64_t node(const Lattice& lattice, int i, int j, int k, const std::array<int, 3>& at) {
  return lattice.at(2 * i + at[0], 2 * j + at[1], 2 * k + at[2]);
}

using Nodes = std::vector<std::array<int, 3>>;
const Nodes kTriquadratic = {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {0, 0, 2}, {2, 0, 2}, {2, 2, 2},
                             {0, 2, 2}, {1, 0, 0}, {2, 1, 0}, {1, 2, 0}, {0, 1, 0}, {1, 0, 2}, {2, 1, 2},
                             {1, 2, 2}, {0, 1, 2}, {0, 0, 1}, {2, 0, 1}, {2, 2, 1}, {0, 2, 1}, {0, 1, 1},
                             {2, 1, 1}, {1, 0, 1}, {1, 2, 1}, {1, 1, 0}, {1, 1, 2}, {1, 1, 1}};
const Nodes kQuadratic(kTriquadratic.begin(), kTriquadratic.begin() + 20);
// Two wedges on either side of the diagonal x = y.
const Nodes kLowerWedge = {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 0, 2}, {2, 0, 2}, {2, 2, 2}, {1, 0, 0}, {2, 1, 0},
                           {1, 1, 0}, {1, 0, 2}, {2, 1, 2}, {1, 1, 2}, {0, 0, 1}, {2, 0, 1}, {2, 2, 1}};
const Nodes kUpperWedge = {{0, 0, 0}, {2, 2, 0}, {0, 2, 0}, {0, 0, 2}, {2, 2, 2}, {0, 2, 2}, {1, 1, 0}, {1, 2, 0},
                           {0, 1, 0}, {1, 1, 2}, {1, 2, 2}, {0, 1, 2}, {0, 0, 1}, {2, 2, 1}, {0, 2, 1}};

struct QuadraticCase {
  const char* name;
  std::uint8_t type;
  std::vector<Nodes> cells;  ///< of each block
  int trianglesOnSide;       ///< of a block's side, the same for all six
};

class QuadraticCells : public testing::TestWithParam<QuadraticCase> {};

TEST_P(QuadraticCells, ConformAtTheirMidNodes) {
  constexpr int kBlocks = 3;
  for (unsigned seed = 1; seed <= 3; ++seed) {
    Lattice lattice(2 * kBlocks, 0.05, seed);
    for (int k = 0; k < kBlocks; ++k)
      for (int j = 0; j < kBlocks; ++j)
        for (int i = 0; i < kBlocks; ++i)
          for (const Nodes& nodes : GetParam().cells) {
            std::vector<std::int64_t> numbers;
            for (const auto& at : nodes) numbers.push_back(node(lattice, i, j, k, at));
            test::addCell(lattice.soup, GetParam().type, numbers);
          }
    const TetMesh mesh = cutIntoTetrahedra(lattice.soup, "test");
    EXPECT_EQ(test::boundaryFaces(mesh), GetParam().trianglesOnSide * 6 * kBlocks * kBlocks);
    EXPECT_GT(test::smallestVolume(mesh), 0);
    EXPECT_NEAR(test::totalVolume(mesh), 8 * kBlocks * kBlocks * kBlocks, 1e-11);
  }
}

INSTANTIATE_TEST_SUITE_P(All, QuadraticCells,
                         testing::Values(QuadraticCase{"TriquadraticHexahedra", 29, {kTriquadratic}, 8},
                                         QuadraticCase{"QuadraticHexahedra", 25, {kQuadratic}, 6}),
                         [](const auto& test) { return std::string(test.param.name); });

TEST(QuadraticCells, WedgesConformAtTheirMidNodes) {
  Lattice lattice(4, 0, 3);
  for (int k = 0; k < 2; ++k)
    for (int j = 0; j < 2; ++j)
      for (int i = 0; i < 2; ++i)
        for (const Nodes& nodes : {kLowerWedge, kUpperWedge}) {
          std::vector<std::int64_t> numbers;
          for (const auto& at : nodes) numbers.push_back(node(lattice, i, j, k, at));
          test::addCell(lattice.soup, 26, numbers);
        }
  const TetMesh mesh = cutIntoTetrahedra(lattice.soup, "test");
  EXPECT_EQ(mesh.tetrahedra.size(), 16u * 26u);
  // Above and below two triangles of four each, at the four sides quadrilaterals of six.
  EXPECT_EQ(test::boundaryFaces(mesh), 2 * 4 * 8 + 4 * 4 * 6);
  EXPECT_NEAR(test::totalVolume(mesh), 64, 1e-12);
}

TEST(CellsConform, PrismsOfFiveAndSixSidesStandOnEachOther) {
  for (const int sides : {5, 6})
    for (unsigned seed = 1; seed < 20; ++seed) {
      std::mt19937 random(seed);
      std::vector<std::int64_t> numbers(static_cast<std::size_t>(3 * sides));
      for (std::size_t i = 0; i < numbers.size(); ++i) numbers[i] = static_cast<std::int64_t>(i);
      std::shuffle(numbers.begin(), numbers.end(), random);
      CellSoup soup;
      soup.points.resize(numbers.size());
      for (int layer = 0; layer < 3; ++layer)
        for (int i = 0; i < sides; ++i)
          soup.points[static_cast<std::size_t>(numbers[static_cast<std::size_t>(layer * sides + i)])] =
              Vec3(std::cos(2 * M_PI * i / sides), std::sin(2 * M_PI * i / sides), layer);
      for (int layer = 0; layer < 2; ++layer)
        test::addCell(soup, static_cast<std::uint8_t>(10 + sides),
                      {numbers.begin() + layer * sides, numbers.begin() + (layer + 2) * sides});
      const TetMesh mesh = cutIntoTetrahedra(soup, "test");
      EXPECT_EQ(test::boundaryFaces(mesh), 2 * (sides - 2) + 2 * 2 * sides);
      EXPECT_NEAR(test::totalVolume(mesh), sides * std::sin(2 * M_PI / sides), 1e-13);
    }
}

TEST(CellsConform, PiecesThatMeetInDoubledPointsAreWeldedBeforeTheyAreCut) {
  // Two cubes with points of their own, numbered so that the lowest of the shared square is not the same in both.
  CellSoup soup;
  for (int cube = 0; cube < 2; ++cube)
    for (int n = 0; n < 8; ++n) {
      const int bits = cube == 0 ? n : 7 - n;
      soup.points.emplace_back(cube + (bits & 1), bits >> 1 & 1, bits >> 2);
    }
  addVoxel(soup, {0, 1, 3, 2, 4, 5, 7, 6});
  addVoxel(soup, {15, 14, 12, 13, 11, 10, 8, 9});
  const TetMesh mesh = cutIntoTetrahedra(soup, "test");
  EXPECT_EQ(mesh.points.size(), 12u);
  EXPECT_EQ(test::boundaryFaces(mesh), 2 * 10);
  EXPECT_NEAR(test::totalVolume(mesh), 2, 1e-14);
  EXPECT_THAT(mesh.notes, testing::ElementsAre(testing::HasSubstr("welded 4 points")));
}

}  // namespace
}  // namespace havs
