#include "reference/edge_mask.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/parallel.h"
#include "support/meshes.h"
#include "support/views.h"

namespace havs {
namespace {

/// Distance from p to the segment from a to b, from the three cases of its definition.
double distanceToSegment(const Vec2& p, const Vec2& a, const Vec2& b) {
  const Vec2 along = b - a;
  if (dot(p - a, along) <= 0) return length(p - a);
  if (dot(p - b, along) >= 0) return length(p - b);
  return std::abs(along.x * (p.y - a.y) - along.y * (p.x - a.x)) / length(along);
}

/// Every boundary edge against every pixel.
std::vector<unsigned char> bruteForce(const std::vector<Vec3>& points, const Faces& faces, const View& view,
                                      double distance) {
  std::vector<unsigned char> mask(static_cast<std::size_t>(view.width * view.height), 0);
  for (std::size_t f = 0; f < faces.size(); ++f) {
    if (!faces.isBoundary(f)) continue;
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec2 a(view.project(points[faces.vertices[f][i]])), b(view.project(points[faces.vertices[f][(i + 1) % 3]]));
      for (int y = 0; y < view.height; ++y)
        for (int x = 0; x < view.width; ++x)
          if (distanceToSegment({x + 0.5, y + 0.5}, a, b) <= distance)
            mask[static_cast<std::size_t>(y * view.width + x)] = 1;
    }
  }
  return mask;
}

struct Case {
  Faces faces;
  LocalFrame frame;
  std::vector<Vec3> points;
  explicit Case(const TetMesh& mesh)
      : faces(buildFaces(mesh)), frame(localFrame(mesh)), points(localPoints(mesh, frame)) {}
};

std::ptrdiff_t marked(const std::vector<unsigned char>& mask) { return std::count(mask.begin(), mask.end(), 1); }

TEST(EdgeMask, AgreesWithEveryEdgeAgainstEveryPixel) {
  for (const TetMesh& mesh : {test::singleTetrahedron(), test::box(3, test::Cut::five), test::oGrid(2, 7, 1)}) {
    const Case scene(mesh);
    for (const Projection projection : {Projection::perspective, Projection::orthographic})
      for (const double zoom : {1.0, 5.0})  // 5: edges pass the picture's border
        for (const double distance : {1.0 / 128, 0.3, 2.5}) {
          const View view = test::viewFrom(scene.frame, 25, 40, 50, projection, zoom);
          const auto mask = boundaryEdgeMask(scene.points, scene.faces, view, distance);
          EXPECT_EQ(mask, bruteForce(scene.points, scene.faces, view, distance));
          if (distance > 0.1) {
            EXPECT_GT(marked(mask), 0);
          }
        }
  }
}

// The square x = +-0.5 of a box of edge 1 in a picture 2 units high, 64 pixels: its sides run 16 pixels from the
// border, half a pixel from the centres of two columns (rows). Only edges along the view's axes: the mesh is one cell
// whose shadow they are.
TEST(EdgeMask, OfAnEdgeSeenAlongAnAxisInClosedForm) {
  TetMesh mesh;
  mesh.points = {{-0.5, -0.5, 0}, {0.5, -0.5, 0}, {-0.5, 0.5, 0}, {-0.5, -0.5, 1}};
  mesh.tetrahedra = {{0, 1, 2, 3}};
  const Faces faces = buildFaces(mesh);
  View view;
  view.orthographic = true;
  view.width = view.height = 64;
  view.forward = {0, 0, -1};
  view.right = {1, 0, 0};
  view.up = {0, 1, 0};
  // Legs at column 16 and row 48; the hypotenuse from (16, 16) to (48, 48) passes through the centres of 32 pixels.
  EXPECT_EQ(marked(boundaryEdgeMask(mesh.points, faces, view, 0.25)), 32);
  // 0.5 reaches the centres on both sides of the legs: columns 15 and 16, rows 16 to 47, and rows 47 and 48, columns 16
  // to 47; of these the hypotenuse has pixels (16, 16) and (47, 47), the legs share (16, 47).
  EXPECT_EQ(marked(boundaryEdgeMask(mesh.points, faces, view, 0.5)), 32 + 64 + 64 - 3);
}

// An edge that passes beside the eye and on behind it is marked as far as it lies in front.
TEST(EdgeMask, ClipsEdgesAtTheEyePlane) {
  TetMesh mesh;
  mesh.points = {{0.1, -0.2, -3}, {0.1, -0.2, 2}, {-4, -1, 2}, {0.1, -5, 2}};
  mesh.tetrahedra = {{0, 1, 2, 3}};
  if (test::volume(mesh, 0) < 0) std::swap(mesh.tetrahedra[0][0], mesh.tetrahedra[0][1]);
  const Faces faces = buildFaces(mesh);
  View view;
  view.width = view.height = 40;
  view.forward = {0, 0, -1};
  view.right = {1, 0, 0};
  view.up = {0, 1, 0};
  const double distance = 0.6;
  const auto mask = boundaryEdgeMask(mesh.points, faces, view, distance);
  // The same by samples along each edge, those in front of the eye: 0.05 pixel for what lies between two samples.
  std::vector<double> nearest(mask.size(), 1e30);
  for (int i = 0; i < 4; ++i)
    for (int j = i + 1; j < 4; ++j)
      for (int s = 0; s <= 40000; ++s) {
        const Vec3 p =
            mix(mesh.points[static_cast<std::size_t>(i)], mesh.points[static_cast<std::size_t>(j)], s / 40000.0);
        if (dot(view.forward, p) <= 0) continue;
        const Vec3 at = view.project(p);
        if (std::abs(at.x) > 100 || std::abs(at.y) > 100) continue;
        for (int y = std::max(0, int(at.y) - 2); y < std::min(40.0, at.y + 2); ++y)
          for (int x = std::max(0, int(at.x) - 2); x < std::min(40.0, at.x + 2); ++x) {
            double& d = nearest[static_cast<std::size_t>(40 * y + x)];
            d = std::min(d, std::hypot(x + 0.5 - at.x, y + 0.5 - at.y));
          }
      }
  EXPECT_GT(marked(mask), 20);
  for (std::size_t i = 0; i < mask.size(); ++i) {
    if (mask[i] != 0) {
      EXPECT_LT(nearest[i], distance + 0.05);
    } else {
      EXPECT_GT(nearest[i], distance - 1e-9);
    }
  }
}

TEST(EdgeMask, IsTheSameForAnyNumberOfThreads) {
  const Case scene(test::ball(12));
  const View view = test::viewFrom(scene.frame, 30, 20, 200);
  auto mask = [&](std::size_t threads) {
    const ThreadLimit limit(threads);
    return boundaryEdgeMask(scene.points, scene.faces, view, 0.5);
  };
  EXPECT_EQ(mask(1), mask(4));
}

TEST(EdgeMask, DefaultMarksFewPixels) {
  const Case scene(test::box(8));
  const View view = test::viewFrom(scene.frame, 30, 20, 512);
  // A line through n pixels of a column or row comes within 1/128 of the centre of about n / 64 of them; 12 edges of
  // the box and 3 * 8 * 8 lines of up to 200 pixels on each of its 6 sides, both seen and hidden.
  const auto count = marked(boundaryEdgeMask(scene.points, scene.faces, view));
  EXPECT_GT(count, 0);
  EXPECT_LT(count, 512 * 512 / 50);
}

}  // namespace
}  // namespace havs
