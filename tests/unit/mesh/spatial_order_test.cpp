#include "mesh/spatial_order.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <random>

#include "core/parallel.h"
#include "mesh/defects.h"
#include "mesh/faces.h"
#include "support/meshes.h"

namespace havs {
namespace {

/// Points and cells in another order.
TetMesh shuffled(TetMesh mesh) {
  std::mt19937 random(3);
  std::vector<Index> place(mesh.points.size());
  std::iota(place.begin(), place.end(), Index{0});
  std::shuffle(place.begin(), place.end(), random);
  std::vector<Vec3> points(mesh.points.size());
  for (std::size_t i = 0; i < points.size(); ++i) points[place[i]] = mesh.points[i];
  mesh.points = std::move(points);
  for (Tetrahedron& cell : mesh.tetrahedra)
    for (Index& v : cell) v = place[v];
  std::shuffle(mesh.tetrahedra.begin(), mesh.tetrahedra.end(), random);
  return mesh;
}

void expectPermutation(std::vector<Index> numbers, std::size_t count) {
  std::sort(numbers.begin(), numbers.end());
  std::vector<Index> all(count);
  std::iota(all.begin(), all.end(), Index{0});
  EXPECT_EQ(numbers, all);
}

/// Mean distance from each cell to the next.
double meanStep(const TetMesh& mesh) {
  const auto middle = [&](const Tetrahedron& t) {
    return (mesh.points[t[0]] + mesh.points[t[1]] + mesh.points[t[2]] + mesh.points[t[3]]) / 4.0;
  };
  double sum = 0;
  for (std::size_t c = 1; c < mesh.tetrahedra.size(); ++c)
    sum += length(middle(mesh.tetrahedra[c]) - middle(mesh.tetrahedra[c - 1]));
  return sum / static_cast<double>(mesh.tetrahedra.size() - 1);
}

TEST(SpatialOrder, PutsNeighboursNearWhateverTheUnit) {
  for (const double unit : {1e-200, 1.0, 1e300}) {
    TetMesh mesh = shuffled(test::box(12, test::Cut::six, 0.2));
    const double step = meanStep(mesh);
    for (Vec3& p : mesh.points) p *= unit;
    const SpatialNumbers numbers = spatialNumbers(mesh.points, mesh.tetrahedra);
    expectPermutation(numbers.points, mesh.points.size());
    expectPermutation(numbers.cells, mesh.tetrahedra.size());
    TetMesh ordered = renumbered(mesh, numbers);
    for (Vec3& p : ordered.points) p /= unit;
    EXPECT_LT(meanStep(ordered), 0.15 * step);  // 0.07: within a cube and to the next
  }
}

TEST(SpatialOrder, CellsKeepTheirPlacesAndCorners) {
  const TetMesh mesh = shuffled(test::ball(5));
  const SpatialNumbers numbers = spatialNumbers(mesh.points, mesh.tetrahedra);
  const TetMesh ordered = renumbered(mesh, numbers);
  for (std::size_t c = 0; c < ordered.tetrahedra.size(); ++c)
    for (std::size_t i = 0; i < 4; ++i)
      EXPECT_EQ(ordered.points[ordered.tetrahedra[c][i]], mesh.points[mesh.tetrahedra[numbers.cells[c]][i]]);
  std::vector<double> values(mesh.points.size());
  std::iota(values.begin(), values.end(), 0.0);
  const std::vector<double> moved = renumbered(values, numbers.points);
  for (std::size_t i = 0; i < moved.size(); ++i) EXPECT_EQ(moved[i], numbers.points[i]);
}

TEST(SpatialOrder, TakesPointsThatAreNotFiniteAndPointsAtOnePlace) {
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  TetMesh mesh = test::box(2);
  mesh.points[3] = Vec3(nan, infinity, -infinity);
  SpatialNumbers numbers = spatialNumbers(mesh.points, mesh.tetrahedra);
  expectPermutation(numbers.points, mesh.points.size());
  expectPermutation(numbers.cells, mesh.tetrahedra.size());
  for (Vec3& p : mesh.points) p = Vec3(1, 2, 3);
  numbers = spatialNumbers(mesh.points, mesh.tetrahedra);
  EXPECT_TRUE(std::is_sorted(numbers.points.begin(), numbers.points.end()));
}

TEST(SpatialOrder, IsTheSameForAnyNumberOfThreads) {
  const TetMesh mesh = shuffled(test::box(14, test::Cut::six, 0.25));
  const auto numbersWith = [&](std::size_t threads) {
    const ThreadLimit limit(threads);
    return spatialNumbers(mesh.points, mesh.tetrahedra);
  };
  const SpatialNumbers one = numbersWith(1), four = numbersWith(4);
  EXPECT_EQ(one.points, four.points);
  EXPECT_EQ(one.cells, four.cells);
}

TEST(SoundMesh, IsOneThatRepairLeavesAlone) {
  EXPECT_TRUE(isSound(test::box(3, test::Cut::five, 0.2)));
  TetMesh inverted = test::box(2);
  std::swap(inverted.tetrahedra[7][0], inverted.tetrahedra[7][1]);
  EXPECT_FALSE(isSound(inverted));
  TetMesh spare = test::box(2);
  spare.points.emplace_back(0, 0, 0);
  EXPECT_FALSE(isSound(spare));
  TetMesh broken = test::box(2);
  broken.points[5].y = std::numeric_limits<double>::infinity();
  EXPECT_FALSE(isSound(broken));
  TetMesh flat = test::box(2);
  flat.tetrahedra[4] = {0, 1, 2, 1};
  EXPECT_FALSE(isSound(flat));
}

TEST(PlainFaces, AreThoseOfTwoCellsAtMostOnOppositeSides) {
  EXPECT_TRUE(buildFaces(shuffled(test::box(6, test::Cut::six, 0.2))).plain);
  TetMesh twice = test::box(3);
  twice.tetrahedra.push_back(twice.tetrahedra[20]);
  EXPECT_FALSE(buildFaces(twice).plain);
  TetMesh oneSide;
  oneSide.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 2}};
  oneSide.tetrahedra = {{0, 1, 2, 3}, {0, 1, 2, 4}};
  EXPECT_FALSE(buildFaces(oneSide).plain);
}

}  // namespace
}  // namespace havs
