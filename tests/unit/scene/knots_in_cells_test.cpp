#include "scene/knots_in_cells.h"

#include <gtest/gtest.h>

#include "support/meshes.h"

namespace havs {
namespace {

/// A box of 6 cubes of edge 1/3 along each side whose field goes from 0 to 1 along x, so that each cell, cut from a
/// cube, spans a sixth of it, under a transfer function with `knots` equal steps.
PreparedScene slices(std::size_t knots) {
  TetMesh mesh = test::box(6);
  mesh.pointFields.push_back({"p", 1, test::pointValues(mesh.points, [](const Vec3& p) { return 0.5 + 0.5 * p.x; })});
  StageTimes stages;
  PreparedScene prepared = prepareScene(Scene{}, std::move(mesh), stages);
  prepared.curve.knots.clear();
  for (std::size_t i = 0; i <= knots; ++i) {
    const double s = static_cast<double>(i) / static_cast<double>(knots);
    prepared.curve.knots.push_back({s, {1, 1, 1}, 1});
  }
  return prepared;
}

TEST(KnotsInCells, CountsThoseBetweenTheCellsScalars) {
  EXPECT_NEAR(meanKnotsInCells(slices(1)), 0, 1e-12);
  EXPECT_NEAR(meanKnotsInCells(slices(12)), 1, 0.4);  // in each layer one, and those at its two ends by rounding
  EXPECT_NEAR(meanKnotsInCells(slices(600)), 99.5, 1);
}

TEST(KnotsInCells, LeavesOutCellsThatShowNothing) {
  PreparedScene half = slices(600);
  for (auto& knot : half.curve.knots) knot.kappa = knot.s < 0.5 ? 1 : 0;
  std::erase_if(half.curve.knots, [](const auto& knot) { return knot.s > 0.51 && knot.s < 1; });
  EXPECT_GT(meanKnotsInCells(half), 80);  // those where nothing shows have none
}

TEST(KnotsInCells, AreNoneInCellData) {
  TetMesh mesh = test::box(2);
  Field cells{"c", 1, {}};
  for (std::size_t i = 0; i < mesh.tetrahedra.size(); ++i) cells.values.push_back(static_cast<double>(i));
  mesh.cellFields.push_back(cells);
  StageTimes stages;
  Scene scene;
  scene.transferFunction = "shells";
  EXPECT_EQ(prepareScene(scene, std::move(mesh), stages).knotsInCells, 0);
}

}  // namespace
}  // namespace havs
