#include "overlay/boundary_layers.h"

#include <gtest/gtest.h>

#include "core/parallel.h"
#include "overlay/line_coverage.h"
#include "reference/reference_renderer.h"
#include "support/meshes.h"
#include "support/views.h"

namespace havs {
namespace {

PreparedScene prepared(TetMesh mesh) {
  const std::vector<double> values = test::constantField(mesh.points, 1);
  mesh.pointFields = {{"s", 1, values}};
  StageTimes stages;
  return prepareScene({}, std::move(mesh), stages);
}

Overlays surface(double opacity) {
  Overlays overlays;
  overlays.surface = BoundarySurface{{1, 1, 1}, opacity, false};
  return overlays;
}

// A convex mesh is met twice, where the reference's first segment begins and its last one ends.
TEST(BoundaryLayers, LieWhereRaysEnterAndLeaveTheMesh) {
  for (const TetMesh& mesh : {test::ball(4), test::box(3, test::Cut::five)}) {
    const PreparedScene scene = prepared(mesh);
    for (const Projection projection : {Projection::perspective, Projection::orthographic}) {
      const View view = test::viewFrom(scene.frame, 25, 40, 50, projection);
      const RayLayers layers = BoundaryLayers(scene, surface(0.5)).of(view);
      int met = 0;
      visitRays(scene, view,
                [&](int x, int y, std::span<const CellSegment> segments) {
                  const auto found = layers.at(x, y);
                  ASSERT_EQ(found.size(), segments.empty() ? 0u : 2u) << x << ',' << y;
                  if (segments.empty()) return;
                  EXPECT_NEAR(found[0].distance, segments.front().entry, 1e-13);
                  EXPECT_NEAR(found[1].distance, segments.back().exit, 1e-13);
                  ++met;
                },
                {.side = 64});
      EXPECT_GT(met, 500);
    }
  }
}

TEST(BoundaryLayers, AreThoseBeforeTheEye) {
  const PreparedScene scene = prepared(test::box(3));
  Camera camera;
  camera.eye = Vec3{0.1, 0.2, 0.3};
  camera.target = Vec3{-0.5, 0.1, -1};
  const View view = makeView(camera, scene.frame, 40, 30);
  const RayLayers layers = BoundaryLayers(scene, surface(1)).of(view);
  for (int y = 0; y < 30; ++y)
    for (int x = 0; x < 40; ++x) {
      const auto found = layers.at(x, y);
      ASSERT_EQ(found.size(), 1u) << "the box is left once";
      EXPECT_GT(found[0].distance, view.rayScale(x + 0.5, y + 0.5) * view.depth(view.eye));
    }
}

TEST(BoundaryLayers, SurfaceIsShadedByItsAngleToTheRay) {
  const PreparedScene scene = prepared(test::box(2));
  Overlays overlays;
  overlays.surface = BoundarySurface{{1, 0.5, 0}, 0.5, true};
  for (const double azimuth : {0.0, 30.0}) {
    const View view = test::viewFrom(scene.frame, azimuth, 0, 11, Projection::orthographic);
    const auto layer = BoundaryLayers(scene, overlays).of(view).at(5, 5)[0];
    const double light = 0.3 + 0.7 * std::cos(azimuth * 3.14159265358979 / 180);
    EXPECT_NEAR(static_cast<double>(layer.rgba[0]), 0.5 * light, 1e-6);
    EXPECT_NEAR(static_cast<double>(layer.rgba[1]), 0.25 * light, 1e-6);
    EXPECT_EQ(layer.rgba[3], 0.5f);
  }
}

// Against the distances of the picture's pixels to the projected edges, computed another way.
TEST(BoundaryLayers, WireFrameCoversByTheDistanceToTheEdgesOfItsFace) {
  const PreparedScene scene = prepared(test::singleTetrahedron());
  Overlays overlays;
  overlays.wireFrame = WireFrame{{1, 1, 1}, 3.5, 0.75, {}};
  const View view = test::viewFrom(scene.frame, 25, 40, 60);
  const RayLayers layers = BoundaryLayers(scene, overlays).of(view);
  const auto distance = [&](const Vec2& p, Index i, Index j) {
    const Vec2 a(view.project(scene.points[i])), b(view.project(scene.points[j]));
    const double share = std::clamp(dot(p - a, b - a) / dot(b - a, b - a), 0.0, 1.0);
    return length(p - (a + share * (b - a)));
  };
  std::size_t expected = 0;
  for (int y = 0; y < 60; ++y)
    for (int x = 0; x < 60; ++x) {
      std::vector<double> alphas;  // of the faces met
      for (const auto& [a, b, c] : scene.faces.vertices) {
        const Vec2 p(x + 0.5, y + 0.5),
            q[3] = {Vec2(view.project(scene.points[a])), Vec2(view.project(scene.points[b])),
                    Vec2(view.project(scene.points[c]))};
        const auto side = [&](int i) {
          const Vec2 u = q[(i + 1) % 3] - q[i], v = p - q[i];
          return u.x * v.y - u.y * v.x > 0;
        };
        if (side(0) != side(1) || side(1) != side(2)) continue;
        const double nearest = std::min({distance(p, a, b), distance(p, b, c), distance(p, c, a)});
        if (const double covered = lineCoverage(nearest, 3.5); covered > 0) alphas.push_back(0.75 * covered);
      }
      const auto found = layers.at(x, y);
      ASSERT_EQ(found.size(), alphas.size()) << x << ',' << y;
      std::vector<double> got;
      for (const RayLayer& layer : found) got.push_back(static_cast<double>(layer.rgba[3]));
      std::sort(got.begin(), got.end());
      std::sort(alphas.begin(), alphas.end());
      for (std::size_t i = 0; i < got.size(); ++i) EXPECT_NEAR(got[i], alphas[i], 1e-6);
      expected += found.size();
    }
  EXPECT_GT(expected, 500u);
}

TEST(FeatureEdges, AreTheEdgesOfTheBox) {
  const PreparedScene scene = prepared(test::box(3));
  const std::vector<BoundaryFace> faces = boundaryFaces(scene);
  EXPECT_EQ(faces.size(), 6u * 9 * 2);
  const auto count = [&](double angle) { return FeatureEdges(faces, scene.points.size(), angle).all().size(); };
  EXPECT_EQ(count(0), 12u * 3 * 2) << "twelve edges of three parts, on two faces each";
  EXPECT_EQ(count(89), 12u * 3 * 2);
  EXPECT_EQ(count(90), 0u);
  const FeatureEdges edges(faces, scene.points.size(), 45);
  for (Index p = 0; p < scene.points.size(); ++p) {
    const Vec3 at = scene.points[p] / scene.frame.halfSize.x * scene.frame.radius;
    int onSides = 0;
    for (int i = 0; i < 3; ++i) onSides += std::abs(at[i]) > 0.99 ? 1 : 0;
    EXPECT_EQ(edges.at(p).size(), onSides == 3 ? 6u : onSides == 2 ? 4u : 0u) << p;
    for (const std::uint32_t e : edges.at(p)) EXPECT_TRUE(edges.all()[e].from == p || edges.all()[e].to == p);
  }
}

// Every pixel whose ray meets a side of the box near one of the side's edges has its line, whichever triangle it meets.
TEST(FeatureEdges, DoNotBreakWhereTrianglesMeetThemByACornerOnly) {
  const PreparedScene scene = prepared(test::box(6));
  Overlays overlays;
  overlays.wireFrame = WireFrame{{0, 0, 0}, 3, 1, 45};
  const View view = test::viewFrom(scene.frame, 0, 0, 120, Projection::orthographic);
  const RayLayers layers = BoundaryLayers(scene, overlays).of(view);
  const double half = scene.frame.halfSize.x / scene.frame.radius;
  const Vec3 low = view.project({-half, half, half}), high = view.project({half, -half, half});
  for (int y = 0; y < 120; ++y)
    for (int x = 0; x < 120; ++x) {
      const double inside = std::min({x + 0.5 - low.x, high.x - x - 0.5, y + 0.5 - low.y, high.y - y - 0.5});
      const auto found = layers.at(x, y);
      const double covered = inside > 0 ? lineCoverage(inside, 3) : 0;
      EXPECT_EQ(found.size(), covered > 1e-6 ? 2u : 0u) << x << ',' << y;
      for (const RayLayer& layer : found) EXPECT_NEAR(static_cast<double>(layer.rgba[3]), covered, 1e-6);
    }
}

TEST(BoundaryLayers, DoNotDependOnTheNumberOfThreads) {
  const PreparedScene scene = prepared(test::nestedShells(4));
  Overlays overlays = surface(0.5);
  overlays.wireFrame = WireFrame{{0, 0, 0}, 1.5, 1, 20};
  const View view = test::viewFrom(scene.frame, 200, -30, 90);
  const RayLayers all = BoundaryLayers(scene, overlays).of(view);
  const ThreadLimit one(1);
  const RayLayers alone = BoundaryLayers(scene, overlays).of(view);
  EXPECT_EQ(all.begin, alone.begin);
  ASSERT_EQ(all.layers.size(), alone.layers.size());
  for (std::size_t i = 0; i < all.layers.size(); ++i) {
    EXPECT_EQ(all.layers[i].distance, alone.layers[i].distance);
    EXPECT_EQ(all.layers[i].rgba, alone.layers[i].rgba);
  }
}

}  // namespace
}  // namespace havs
