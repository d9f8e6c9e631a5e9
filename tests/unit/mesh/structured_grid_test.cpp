#include <gmock/gmock.h>

#include "mesh/cells.h"
#include "unit/mesh/mesh_checks.h"

namespace havs {
namespace {
using testing::HasSubstr;
using Size = std::array<std::size_t, 3>;

std::vector<Vec3> gridPoints(const Size& size) {
  std::vector<Vec3> points;
  for (std::size_t k = 0; k < size[2]; ++k)
    for (std::size_t j = 0; j < size[1]; ++j)
      for (std::size_t i = 0; i < size[0]; ++i) points.emplace_back(i, j, k);
  return points;
}

TEST(StructuredGrid, FiveACellThatConformByParity) {
  for (const Size& size : {Size{2, 2, 2}, Size{6, 5, 4}, Size{3, 2, 7}}) {
    const TetMesh mesh = cutStructuredGrid(size, gridPoints(size), {}, {}, {}, "grid");
    const auto cells = (size[0] - 1) * (size[1] - 1) * (size[2] - 1);
    const auto squares =
        2 * ((size[0] - 1) * (size[1] - 1) + (size[1] - 1) * (size[2] - 1) + (size[2] - 1) * (size[0] - 1));
    EXPECT_EQ(mesh.tetrahedra.size(), 5 * cells);
    EXPECT_EQ(mesh.sourceCells, cells);
    EXPECT_EQ(test::boundaryFaces(mesh), static_cast<int>(2 * squares));
    EXPECT_NEAR(test::totalVolume(mesh), static_cast<double>(cells), 1e-12);
    EXPECT_NEAR(test::smallestVolume(mesh), 1.0 / 6, 1e-15);
  }
}

TEST(StructuredGrid, BlankedCellsAreLeftOutWithTheirData) {
  const Size size = {4, 3, 2};
  std::vector<int> blank(24, 1);
  blank[0] = 0;  // a corner of the first cell only
  const Field id{"id", 1, {0, 1, 2, 3, 4, 5}};
  const TetMesh mesh = cutStructuredGrid(size, gridPoints(size), blank, {}, {id}, "grid");
  EXPECT_EQ(mesh.sourceCells, 5u);
  ASSERT_EQ(mesh.cellFields[0].values.size(), 25u);
  for (std::size_t t = 0; t < 25; ++t) EXPECT_EQ(mesh.cellFields[0].values[t], static_cast<double>(t / 5 + 1));
  EXPECT_NEAR(test::totalVolume(mesh), 5, 1e-13);
  EXPECT_THAT(mesh.notes, testing::ElementsAre("left out 1 blanked cells"));
}

TEST(StructuredGrid, BadGridsAreRefused) {
  const Size size = {2, 2, 2};
  const auto error = [&](const Size& s, std::vector<int> blank, std::vector<Field> pointFields) {
    return test::inputError([&] { cutStructuredGrid(s, gridPoints(size), blank, pointFields, {}, "grid"); });
  };
  EXPECT_THAT(error({8, 1, 1}, {}, {}), HasSubstr("grid: a grid of 8 x 1 x 1 points encloses no volume"));
  EXPECT_THAT(error({2, 2, 3}, {}, {}), HasSubstr("comes with 8"));
  EXPECT_THAT(error({std::size_t{1} << 32, std::size_t{1} << 32, 8}, {}, {}), HasSubstr("comes with 8"));
  EXPECT_THAT(error(size, {1, 1}, {}), HasSubstr("2 blanking values"));
  EXPECT_THAT(error(size, {}, {{"p", 1, {1}}}), HasSubstr("'p' has 1 values"));
  EXPECT_THAT(error(size, std::vector<int>(8, 0), {}), HasSubstr("every cell of the grid is blanked"));
}

}  // namespace
}  // namespace havs
