// Shadows and ambient occlusion in media whose transmittances are known in closed form.
#include "light/shadows.h"

#include <gtest/gtest.h>

#include "core/error.h"
#include "light/ambient_occlusion.h"
#include "unit/light/light_scene.h"

namespace havs::test {
namespace {

constexpr double kKappa = 1.3;
constexpr double kShadowTurned = 1e-10;  // mesh_tracer_test.cpp: 35 times the turn of a ray, times kappa

TEST(Shadows, ConstantBoxAtEveryPoint) {
  const LightScene scene = constantScene(box(6, Cut::six, 0.2), kKappa);
  const MeshTracer tracer(scene.medium());
  for (const Vec3& towards : {Vec3(1, 0, 0), Vec3(0, -3, 0), Vec3(1, 1, 0), Vec3(1, 1, 1), Vec3(0.3, -0.7, 0.6)}) {
    const std::vector<double> found = shadows(tracer, {Light::Kind::directional, towards});
    for (std::size_t p = 0; p < found.size(); ++p) {
      const double l = throughBox(scene.mesh.points[p], normalize(towards), Vec3(-1), Vec3(1)).length();
      EXPECT_NEAR(found[p], std::exp(-kKappa * l), kShadowTurned);
    }
  }
}

TEST(Shadows, OneBoxShadesTheOtherAcrossAGap) {
  const LightScene scene = constantScene(twoBoxes(4, 0.2), kKappa);
  const MeshTracer tracer(scene.medium());
  std::size_t shadedFromAfar = 0;
  for (const Vec3& towards : {Vec3(1, 0, 0), Vec3(-1, 0, 0), Vec3(0, 1, 0), Vec3(1, 1, 0), Vec3(0.8, 0.3, -0.2)}) {
    const Vec3 d = normalize(towards);
    const std::vector<double> found = shadows(tracer, {Light::Kind::directional, towards});
    for (std::size_t p = 0; p < found.size(); ++p) {
      const Vec3& point = scene.mesh.points[p];
      const double left = throughBox(point, d, {-1, -1, -1}, {0, 1, 1}).length();
      const double right = throughBox(point, d, {0.2, -1, -1}, {1.2, 1, 1}).length();
      // Where the ray meets the other box's boundary edge-on it may pass on either side.
      if (d.z == 0 && std::abs(point.z) == 1 && left > 0 && right > 0) continue;
      EXPECT_NEAR(found[p], std::exp(-kKappa * (left + right)), kShadowTurned) << point.x << ' ' << point.y << ' ' << point.z;
      shadedFromAfar += left > 0 && right > 0;
    }
  }
  EXPECT_GT(shadedFromAfar, 300u);
}

TEST(Shadows, PointLightsInsideAndOutside) {
  const LightScene scene = constantScene(box(5, Cut::six, 0.2), kKappa);
  const MeshTracer tracer(scene.medium());
  for (const Vec3& place : {Vec3(0.21, -0.13, 0.4), Vec3(2, 3, -1.5), scene.mesh.points[100]})
    for (const double from : {0.0, 0.3}) {
      const std::vector<double> found = shadows(tracer, {Light::Kind::point, place}, {}, from);
      for (std::size_t p = 0; p < found.size(); ++p) {
        const Vec3 way = place - scene.mesh.points[p];
        const double distance = length(way);
        const double inside =
            distance > 0
                ? std::min(distance, throughBox(scene.mesh.points[p], way / distance, Vec3(-1), Vec3(1)).length())
                : 0;
        EXPECT_NEAR(found[p], std::exp(-kKappa * std::max(0.0, inside - from)), kShadowTurned);
      }
    }
}

TEST(Shadows, OnlyWhatIsAskedFor) {
  const LightScene scene = constantScene(box(3), kKappa);
  const MeshTracer tracer(scene.medium());
  std::vector<std::uint8_t> mask(scene.mesh.points.size(), 0);
  mask[21] = mask[40] = 1;
  const Light light{Light::Kind::directional, {0.3, 0.2, 0.5}};
  const std::vector<double> all = shadows(tracer, light), some = shadows(tracer, light, mask);
  const std::vector<double> open = ambientOcclusion(tracer), someOpen = ambientOcclusion(tracer, {}, mask);
  for (std::size_t p = 0; p < all.size(); ++p) {
    EXPECT_EQ(some[p], mask[p] ? all[p] : 1);
    EXPECT_EQ(someOpen[p], mask[p] ? open[p] : 1);
  }
}

TEST(Shadows, RefusesLightsWithoutDirection) {
  const LightScene scene = constantScene(box(1), kKappa);
  const MeshTracer tracer(scene.medium());
  EXPECT_THROW(shadows(tracer, {Light::Kind::directional, Vec3(0)}), Error);
  EXPECT_THROW(shadows(tracer, {Light::Kind::point, Vec3(NAN, 0, 0)}), Error);
  EXPECT_THROW(ambientOcclusion(tracer, {0.0, 64}), Error);
  EXPECT_THROW(ambientOcclusion(tracer, {0.1, 0}), Error);
}

// All rays of a point that is farther than the radius from the boundary have the same length: exact.
TEST(AmbientOcclusion, ConstantMedium) {
  const LightScene scene = constantScene(box(8, Cut::six, 0.2), kKappa);
  const MeshTracer tracer(scene.medium());
  constexpr double kRadius = 0.3;
  const BallValues values = ballValues(tracer, {kRadius, 64});
  const std::vector<double> occlusion = ambientOcclusion(tracer, {kRadius, 64});
  std::size_t inside = 0;
  for (std::size_t p = 0; p < occlusion.size(); ++p) {
    const Vec3 a = abs(scene.mesh.points[p]);
    EXPECT_NEAR(values.occlusion[p], occlusion[p], 1e-15);
    const double room = 1 - std::max({a.x, a.y, a.z});
    if (room > kRadius) {
      EXPECT_NEAR(occlusion[p], std::exp(-kKappa * kRadius), 1e-14);
      EXPECT_NEAR(values.opticalRadius[p], kKappa * kRadius, 1e-14);
      ++inside;
    } else if (room == 0 && (a.x < 0.7) + (a.y < 0.7) + (a.z < 0.7) == 2) {
      // Within a side half of the directions go into the mesh: 30 to 34 of 64.
      EXPECT_NEAR(occlusion[p], 0.5 * (1 + std::exp(-kKappa * kRadius)), 2.0 / 64);
      EXPECT_NEAR(values.opticalRadius[p], 0.5 * kKappa * kRadius, kKappa * kRadius * 2.0 / 64);
    }
  }
  EXPECT_GT(inside, 50u);
}

// Where kappa is linear in space, the mean over the ball is that of its centre, and the mean over all directions of
// exp(-R (k + R g.d / 2)) is exp(-R k) sinh(x) / x with x = R^2 |g| / 2. What 64 directions make of it is measured; it
// falls with their number.
TEST(AmbientOcclusion, LinearExtinctionAndTheNumberOfDirections) {
  const Vec3 g{0.2, -0.15, 0.1};
  TetMesh mesh = box(6, Cut::six, 0.2);
  std::vector<double> scalars = linearField(mesh.points, g);
  const LightScene scene(std::move(mesh), std::move(scalars), curveOf({{0, 0}, {1, 20}}));
  const MeshTracer tracer(scene.medium());
  constexpr double kRadius = 0.4;
  double before = 1;
  for (const auto& [directions, bound] : {std::pair{16, 6e-3}, std::pair{64, 8e-4}, std::pair{1024, 2e-5}}) {
    const BallValues values = ballValues(tracer, {kRadius, static_cast<std::size_t>(directions)});
    double worst = 0, worstRadius = 0;
    for (std::size_t p = 0; p < scene.mesh.points.size(); ++p) {
      const Vec3 a = abs(scene.mesh.points[p]);
      if (1 - std::max({a.x, a.y, a.z}) <= kRadius) continue;
      const double kappa = 20 * scene.scalars[p], x = kRadius * kRadius * 20 * length(g) / 2;
      worst = std::max(worst, std::abs(values.occlusion[p] - std::exp(-kappa * kRadius) * std::sinh(x) / x));
      worstRadius = std::max(worstRadius, std::abs(values.opticalRadius[p] / (kappa * kRadius) - 1));
    }
    EXPECT_LE(worst, bound) << directions;
    EXPECT_LE(worstRadius, 3 * bound) << directions;
    EXPECT_LT(worst, before);
    before = worst;
  }
}

}  // namespace
}  // namespace havs::test
