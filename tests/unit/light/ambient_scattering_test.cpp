#include "light/ambient_scattering.h"

#include <gtest/gtest.h>

#include "unit/light/light_scene.h"

namespace havs::test {
namespace {

// In a constant medium, farther from the boundary than the radius, everything is known but the table.
TEST(AmbientScattering, ConstantMedium) {
  constexpr double kKappa = 2, kRadius = 0.3;
  const LightScene scene = constantScene(box(8, Cut::six, 0.2), kKappa);
  const MeshTracer tracer(scene.medium());
  const std::vector<Light> lights{{Light::Kind::directional, {1, 2, 0.5}, 0.7},
                                  {Light::Kind::point, {0.1, 0.2, 3}, 1.5}};
  const ScatteringData data = scatteringData(tracer, ballValues(tracer, {kRadius, 64}).opticalRadius, kRadius, lights);
  const ScatteringTable table({0.5, 2048, 1});
  const ScatteredLight scattered(table, 0.8);
  const Vec3 eye{0.4, -3, 2}, forward = normalize(Vec3(1, 1, -2));
  for (const ViewRays& view : {ViewRays{false, eye}, ViewRays{true, forward}}) {
    const std::vector<double> found = ambientScattering(data, lights, scattered, scene.mesh.points, view);
    for (std::size_t p = 0; p < found.size(); ++p) {
      const Vec3& point = scene.mesh.points[p];
      const Vec3 a = abs(point);
      if (1 - std::max({a.x, a.y, a.z}) <= kRadius) continue;
      const Vec3 ray = view.parallel ? forward : normalize(point - eye);
      double expected = 0;
      for (const Light& light : lights) {
        const Vec3 d = normalize(light.kind == Light::Kind::point ? light.place - point : light.place);
        const double beyond = throughBox(point, d, Vec3(-1), Vec3(1)).length() - kRadius;
        expected += light.intensity * std::exp(-kKappa * beyond) * scattered(kKappa * kRadius, dot(ray, d));
      }
      EXPECT_NEAR(found[p], expected, 1e-12);
    }
  }
}

TEST(AmbientScattering, ForwardScatteringShinesTowardsTheLight) {
  const LightScene scene = constantScene(box(4), 1);
  const MeshTracer tracer(scene.medium());
  const std::vector<Light> lights{{Light::Kind::directional, {0, 0, 1}}};
  const ScatteringData data = scatteringData(tracer, ballValues(tracer).opticalRadius, 0.1, lights);
  const ScatteredLight scattered(ScatteringTable({0.8, 512, 1}), 1);
  std::vector<std::uint8_t> mask(scene.mesh.points.size(), 1);
  mask[3] = 0;
  const auto seen = [&](const Vec3& along) {
    return ambientScattering(data, lights, scattered, scene.mesh.points, {true, along}, mask);
  };
  const std::vector<double> against = seen({0, 0, 1}), with = seen({0, 0, -1});
  for (std::size_t p = 0; p < against.size(); ++p) {
    if (p != 3)
      EXPECT_GT(against[p], 100 * with[p]);
    else
      EXPECT_EQ(against[p], 0);
  }
}

}  // namespace
}  // namespace havs::test
