// Entries and exits at every pixel, and pictures whose every ray has a closed form: what the inside-count promises.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "support/meshes.h"
#include "support/ordered_scene.h"
#include "support/views.h"

namespace havs {
namespace {

constexpr int kSize = 64;
constexpr double kExtinction = 0.8;

struct Angles {
  double azimuth, elevation;
};
constexpr Angles kAngles[] = {{0, 0}, {90, 0}, {45, 0}, {0, 90}, {30, 20}, {233, -48}};
constexpr Projection kProjections[] = {Projection::perspective, Projection::orthographic};

/// A box in mesh units, +1 for matter and -1 for a hollow in it.
struct SignedBox {
  Vec3 low, high;
  double sign;
};

/// Length of the ray of a pixel inside the box, in local units.
double lengthInBox(const SignedBox& box, const LocalFrame& frame, const View& view, int x, int y) {
  const double u = (2 * (x + 0.5) / view.width - 1) * view.halfWidth;
  const double v = (1 - 2 * (y + 0.5) / view.height) * view.halfHeight;
  const Vec3 offset = u * view.right + v * view.up;
  const Vec3 origin = view.orthographic ? view.center + offset : view.eye;
  const Vec3 direction = view.orthographic ? view.forward : view.forward + offset;
  const Vec3 low = frame.toLocal(box.low), high = frame.toLocal(box.high);
  double enter = -std::numeric_limits<double>::infinity(), leave = std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < 3; ++axis) {
    if (std::abs(direction[axis]) < 1e-14) {  // the view's axes are rounded
      if (origin[axis] <= low[axis] || origin[axis] >= high[axis]) return 0;
      continue;
    }
    const double a = (low[axis] - origin[axis]) / direction[axis], b = (high[axis] - origin[axis]) / direction[axis];
    enter = std::max(enter, std::min(a, b));
    leave = std::min(leave, std::max(a, b));
  }
  return std::max(0.0, leave - enter) * length(direction);
}

/// Draws the mesh from all views with constant extinction and compares every pixel with the closed form.
void expectClosedForm(TetMesh mesh, const std::vector<SignedBox>& boxes) {
  const test::OrderedScene scene(std::move(mesh));
  for (const Projection projection : kProjections)
    for (const auto& [azimuth, elevation] : kAngles) {
      SCOPED_TRACE(std::to_string(azimuth) + " " + std::to_string(elevation));
      const View view = test::viewFrom(scene.frame, azimuth, elevation, kSize, projection);
      const auto result = scene.replay("topological", view, 14, test::constantExtinction(kExtinction));
      EXPECT_EQ(result.misordered, 0u);
      EXPECT_EQ(result.unbalancedPixels, 0u);
      EXPECT_EQ(result.negativePixels, 0u);
      for (int y = 0; y < kSize; ++y)
        for (int x = 0; x < kSize; ++x) {
          double inside = 0;
          for (const SignedBox& box : boxes) inside += box.sign * lengthInBox(box, scene.frame, view, x, y);
          // The replay rounds vertices to 2^-26 pixel, 1e-9 of the picture's height; at grazing faces the length moves
          // more.
          EXPECT_NEAR(result.image[static_cast<std::size_t>(y * kSize + x)][3], -std::expm1(-kExtinction * inside),
                      1e-7)
              << x << " " << y;
        }
    }
}

TEST(InsideCount, ClosedFormOfABox) {
  const SignedBox all{Vec3(-1), Vec3(1), 1};
  expectClosedForm(test::box(4, test::Cut::five), {all});
  expectClosedForm(test::box(4, test::Cut::six, 0.25), {all});
}

TEST(InsideCount, ClosedFormOfTouchingBoxesAndOfGapsThinnerThanAnEdge) {
  for (const double gap : {0.0, 1e-12, 1e-4, 0.1})
    expectClosedForm(test::twoBoxes(2, gap),
                     {{Vec3(-1), Vec3(0, 1, 1), 1}, {Vec3(gap, -1, -1), Vec3(1 + gap, 1, 1), 1}});
}

TEST(InsideCount, ClosedFormOfNestedShells) {
  expectClosedForm(test::nestedShells(1),
                   {{Vec3(-1), Vec3(1), 1}, {Vec3(-0.6), Vec3(0.6), -1}, {Vec3(-0.3), Vec3(0.3), 1}});
}

TEST(InsideCount, ClosedFormOfABoxWithAHole) {
  const double third = 1.0 / 3.0;
  expectClosedForm(test::boxWithHole(3),
                   {{Vec3(-1), Vec3(1), 1}, {Vec3(-third, -third, -1), Vec3(third, third, 1), -1}});
}

// The seam is two layers of boundary faces at one place: the picture is that of the welded grid.
TEST(InsideCount, SeamOfAnOGridDoesNotShow) {
  const test::OrderedScene seam(test::oGrid(3, 12, 3));
  TetMesh mesh = test::oGrid(3, 12, 3);
  for (Tetrahedron& cell : mesh.tetrahedra)
    for (Index& v : cell)
      v = static_cast<Index>(std::find(mesh.points.begin(), mesh.points.end(), mesh.points[v]) - mesh.points.begin());
  const test::OrderedScene welded(mesh);
  ASSERT_GT(seam.faces.boundaryCount, welded.faces.boundaryCount);
  for (const auto& [azimuth, elevation] : kAngles) {
    const View view = test::viewFrom(seam.frame, azimuth, elevation, kSize);
    const auto color = test::constantExtinction(kExtinction);
    const auto one = seam.replay("topological", view, 14, color), other = welded.replay("topological", view, 14, color);
    EXPECT_EQ(one.unbalancedPixels, 0u);
    EXPECT_LT(test::greatestDifference(one.image, other.image), 1e-12);
  }
}

TEST(InsideCount, IsBalancedWhateverTheOrder) {
  for (TetMesh mesh : {test::ball(6), test::boxWithHole(6), test::oGrid(2, 9, 3), test::visibilityCycle(),
                       test::stretchedLayers(6, 2), test::nestedShells(1)}) {
    const test::OrderedScene scene(std::move(mesh));
    for (const auto& [azimuth, elevation] : kAngles)
      for (const char* sort : {"none", "centroid", "topological"})
        EXPECT_EQ(scene.replay(sort, test::viewFrom(scene.frame, azimuth, elevation, kSize), 2).unbalancedPixels, 0u);
  }
}

}  // namespace
}  // namespace havs
