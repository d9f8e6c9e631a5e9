#include <gtest/gtest.h>

#include <algorithm>

#include "core/parallel.h"
#include "light/ambient_scattering.h"
#include "light/point_gradients.h"
#include "unit/light/light_scene.h"

namespace havs::test {
namespace {

TEST(PointCells, AreThoseThatHaveThePoint) {
  const TetMesh mesh = ball(4);
  const PointCells around(mesh.points.size(), mesh.tetrahedra);
  std::vector<std::vector<Index>> expected(mesh.points.size());
  for (std::size_t c = 0; c < mesh.tetrahedra.size(); ++c)
    for (const Index v : mesh.tetrahedra[c]) expected[v].push_back(static_cast<Index>(c));
  for (std::size_t p = 0; p < mesh.points.size(); ++p)
    EXPECT_EQ(std::vector<Index>(around.of(p).begin(), around.of(p).end()), expected[p]);
}

TEST(PointCells, PointsOfSomeCells) {
  const TetMesh mesh = box(2);
  const PointCells around(mesh.points.size(), mesh.tetrahedra);
  std::vector<std::uint8_t> shown(mesh.tetrahedra.size(), 0);
  shown[7] = shown[30] = 1;
  const std::vector<std::uint8_t> mask = pointsOfCells(around, shown);
  for (std::size_t p = 0; p < mask.size(); ++p) {
    const auto has = [&](std::size_t c) {
      return std::count(mesh.tetrahedra[c].begin(), mesh.tetrahedra[c].end(), p) > 0;
    };
    EXPECT_EQ(mask[p], has(7) || has(30) ? 1 : 0);
  }
}

// Everything that is computed for points, with one thread and with two: the same bits.
TEST(PointData, OfAnyNumberOfThreads) {
  const TetMesh mesh = nestedShells(3);
  const LightScene scene(TetMesh(mesh), smoothField(mesh.points), curveOf({{0, 0}, {0.5, 4}, {0.6, 1}, {1, 9}}));
  std::vector<std::vector<double>> found[2];
  for (const std::size_t threads : {1, 2}) {
    const ThreadLimit limit(threads);
    auto& all = found[threads - 1];
    const MeshTracer tracer(scene.medium());
    const std::vector<Light> lights{{Light::Kind::directional, {1, 2, 3}}, {Light::Kind::point, {0.1, 0.9, 2}}};
    BallValues values = ballValues(tracer);
    all.push_back(values.occlusion);
    all.push_back(ambientOcclusion(tracer, {0.5, 16}));
    const ScatteringData data = scatteringData(tracer, values.opticalRadius, 0.1, lights);
    all.insert(all.end(), data.transmittance.begin(), data.transmittance.end());
    const ScatteredLight scattered(ScatteringTable({0.3, 64, 1}), 0.9);
    all.push_back(ambientScattering(data, lights, scattered, scene.mesh.points, {false, {3, 1, 2}}));
    const PointCells around(scene.mesh.points.size(), scene.mesh.tetrahedra);
    all.emplace_back();
    for (const Vec3& g : pointGradients(scene.mesh.points, scene.mesh.tetrahedra, around, scene.scalars, false))
      all.back().insert(all.back().end(), {g.x, g.y, g.z});
  }
  EXPECT_EQ(found[0], found[1]);
}

}  // namespace
}  // namespace havs::test
