#include <gtest/gtest.h>

#include <random>

#include "raster/edge_function.h"
#include "support/views.h"

namespace havs {
namespace {

Vec3 randomPoint(std::mt19937& random) {
  std::uniform_real_distribution<double> unit(-1, 1);
  return {unit(random), unit(random), unit(random)};
}

std::vector<View> views() {
  std::vector<View> all;
  for (const Projection projection : {Projection::perspective, Projection::orthographic})
    for (const double azimuth : {0.0, 37.0, 90.0, 200.0}) {
      Camera camera;
      camera.projection = projection;
      camera.azimuth = azimuth;
      camera.elevation = azimuth / 3 - 20;
      all.push_back(makeView(camera, LocalFrame{}, 64, 48));
    }
  return all;
}

/// The side that the corners' turn tells, where it is clear.
TEST(SideOfEye, IsThatOfThePlane) {
  std::mt19937 random(7);
  for (const View& view : views())
    for (int i = 0; i < 200; ++i) {
      const Vec3 a = randomPoint(random), b = randomPoint(random), c = randomPoint(random);
      const Vec3 toEye = view.orthographic ? Vec3{0} - view.forward : view.eye - a;
      const double height = dot(cross(b - a, c - a), toEye);
      if (std::abs(height) < 1e-9) continue;
      EXPECT_EQ(sideOfEye(a, b, c, view), height > 0 ? 1 : -1);
    }
}

/// And everywhere the one that the fill rule's pixels see: for faces seen edge on, at a pixel on them.
TEST(SideOfEye, IsThatOfThePixelsThatTheFaceCovers) {
  std::mt19937 random(8);
  int covered = 0;
  for (const View& view : views())
    for (int i = 0; i < 2000; ++i) {
      const Vec3 a = randomPoint(random), b = randomPoint(random);
      const Vec3 along = view.orthographic ? view.forward : a - view.eye;
      const Vec3 c = 0.5 * (a + b) + 0.3 * along;  // in the plane of a, b and the eye, but for rounding
      const ScreenPoint p = screenPoint(a, view), q = screenPoint(b, view), r = screenPoint(c, view);
      if (!(p.w > 0 && q.w > 0 && r.w > 0)) continue;
      const double x = 0.5 * (p.x / p.w + q.x / q.w), y = 0.5 * (p.y / p.w + q.y / q.w);
      const int first = exactEdgeSide(p, q, x, y).sign;
      if (first == 0 || exactEdgeSide(q, r, x, y).sign != first || exactEdgeSide(r, p, x, y).sign != first) continue;
      EXPECT_EQ(sideOfEye(a, b, c, view), -first);
      ++covered;
    }
  EXPECT_GT(covered, 100);
}

TEST(SideOfEye, IsNeitherWhereTheCornersLieOnOneLine) {
  for (const View& view : views()) {
    const Vec3 a{0.25, 0.5, -0.5};
    EXPECT_EQ(sideOfEye(a, a, Vec3{0.5, 0.25, 0}, view), 0);
  }
}

}  // namespace
}  // namespace havs
