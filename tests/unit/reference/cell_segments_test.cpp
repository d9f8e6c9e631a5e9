// Every point of a ray inside the mesh belongs to one cell.
#include "reference/cell_segments.h"

#include <gtest/gtest.h>

#include <random>

#include "core/parallel.h"
#include "unit/reference/rays.h"

namespace havs::test {
namespace {

PreparedScene smooth(TetMesh mesh) {
  auto scalars = smoothField(mesh.points);
  return sceneOf(std::move(mesh), std::move(scalars), rampCurve(0, 3));
}

/// In a convex mesh: cells follow one another without a gap, to the bit but for the scaling of depths to distances.
void expectUnbroken(const std::vector<std::vector<CellSegment>>& pixels) {
  for (const auto& segments : pixels)
    for (std::size_t i = 1; i < segments.size(); ++i) {
      ASSERT_EQ(segments[i].entry, segments[i - 1].exit);
      ASSERT_LE(std::abs(segments[i].scalarEntry - segments[i - 1].scalarExit), 1e-15);
    }
}

struct ChordError {
  double most = 0;
  std::size_t seen = 0;
};
/// Of the box [-1, 1]^3.
ChordError chordError(const std::vector<std::vector<CellSegment>>& pixels, const View& view) {
  ChordError error;
  for (int y = 0; y < view.height; ++y)
    for (int x = 0; x < view.width; ++x) {
      const double chord = throughBox(rayOf(view, x, y), Vec3(-1.0), Vec3(1.0)).length();
      error.most =
          std::max(error.most, std::abs(lengthOf(pixels[static_cast<std::size_t>(y * view.width + x)]) - chord));
      error.seen += chord > 0;
    }
  return error;
}

TEST(CellSegments, LengthsAddUpToTheChordFromRandomViews) {
  const PreparedScene scene = smooth(box(6, Cut::five, 0.25));
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> unit(-1, 1);
  ChordError worst;
  for (int i = 0; i < 40; ++i) {
    const Vec3 outward = normalize(Vec3{unit(random), unit(random), unit(random)});
    const Vec3 eye = (2 + 3 * std::abs(unit(random))) * outward;
    const bool orthographic = i % 2 == 0;
    const View view = viewOf(orthographic, eye, {0.1 * unit(random), 0, 0}, orthographic ? 1.8 : 0.6, 60, 50);
    const auto pixels = segmentsOf(scene, view);
    expectUnbroken(pixels);
    const ChordError error = chordError(pixels, view);
    worst = {std::max(worst.most, error.most), worst.seen + error.seen};
  }
  // Roundings of coordinates (50 pixels and 5 local units, to 1e-14 and 1e-15) times the slope of the side that a ray
  // meets: of 60,000 rays the one nearest to a side has a slope of hundreds.
  EXPECT_LE(worst.most, 2e-12);
  EXPECT_GT(worst.seen, 40000u);
}

/// Pixel centres on the corners, edges and faces of the grid, all exact in binary: edge 1/4, pixels 1/4 or 1/8 wide.
View alignedView(int axis, double pixel, double shift) {
  View view;
  view.orthographic = true;
  Vec3 forward{0}, right{0}, up{0};
  forward[axis] = -1;
  right[(axis + 1) % 3] = 1;
  up = cross(right, forward);
  view.forward = forward;
  view.right = right;
  view.up = up;
  view.width = view.height = 32;
  view.halfWidth = view.halfHeight = 16 * pixel;
  view.center = shift * (right - up);
  return view;
}

TEST(CellSegments, RaysThroughEdgesAndCornersOfAGrid) {
  for (const Cut cut : {Cut::five, Cut::six}) {
    const PreparedScene scene = smooth(box(8, cut));
    for (int axis = 0; axis < 3; ++axis)
      for (const double pixel : {0.25, 0.125})
        for (const double offset : {0.5, 0.0}) {  // 0.5: centres on the lines of the grid; 0: on its diagonals
          const View view = alignedView(axis, pixel, offset * pixel);
          const auto pixels = segmentsOf(scene, view);
          expectUnbroken(pixels);
          std::size_t through = 0;
          for (const auto& segments : pixels) {
            const double length = lengthOf(segments);
            EXPECT_TRUE(length == 0 || length == 2) << length;  // no rounding anywhere
            through += length == 2;
          }
          // Centres on the border belong to one side of the box, those on the other do not: as many as it has area.
          EXPECT_EQ(through, static_cast<std::size_t>(4 / (pixel * pixel)));
        }
  }
}

TEST(CellSegments, RaysAlongAFaceInPerspective) {
  // The eye in planes of the grid: cells are seen edge-on, and the picture's middle column and row lie on grid lines.
  const PreparedScene scene = smooth(box(8, Cut::six));
  for (const Vec3& eye : {Vec3{0, 0, 4}, {4, 0, 0}, {0.25, 0.5, 4}, {3, 3, 3}}) {
    const View view = viewOf(false, eye, eye + Vec3{eye.x > 2 ? -1.0 : 0.0, 0, eye.z > 2 ? -1.0 : 0.0}, 0.75, 65, 65);
    const auto pixels = segmentsOf(scene, view);
    expectUnbroken(pixels);
    ChordError error;
    for (int y = 0; y < view.height; ++y)
      for (int x = 0; x < view.width; ++x) {
        const Ray ray = rayOf(view, x, y);
        // A ray in a side of the box may count as in it or not.
        const double inner = throughBox(ray, Vec3(-1 + 1e-12), Vec3(1 - 1e-12)).length();
        const double outer = throughBox(ray, Vec3(-1 - 1e-12), Vec3(1 + 1e-12)).length();
        const double length = lengthOf(pixels[static_cast<std::size_t>(y * view.width + x)]);
        EXPECT_GE(length, inner - 1e-11);
        EXPECT_LE(length, outer + 1e-11);
        error.seen += length > 0;
      }
    EXPECT_GT(error.seen, 300u);
  }
}

TEST(CellSegments, CellsBehindAndAcrossTheEyePlane) {
  const PreparedScene scene = smooth(box(7, Cut::five, 0.2));
  // Beside the box, looking along it and outwards, 127 degrees wide; the eye nearly touches it, too.
  for (const double distance : {0.3, 1e-3, 1e-6})
    for (const Vec3& towards : {Vec3{0, 0, -1}, {0.3, 0.2, -1}, {-1, 0.1, 0.2}, {1, 0.3, 0.2}}) {
      const Vec3 eye{1 + distance, 0.13, 0.21};
      const View view = viewOf(false, eye, eye + towards, 2.0, 70, 70);
      const auto pixels = segmentsOf(scene, view);
      expectUnbroken(pixels);
      const ChordError error = chordError(pixels, view);
      EXPECT_LE(error.most, 1e-11) << distance << ' ' << towards.x;
      if (towards.x < 1) {
        EXPECT_GT(error.seen, 1000u);
      }
    }
}

TEST(CellSegments, FromAnEyeInsideTheMesh) {
  const PreparedScene scene = smooth(box(5, Cut::six, 0.2));
  const View view = viewOf(false, {0.11, 0.07, -0.23}, {0.5, 0.2, -1}, 1.5, 60, 60);
  const auto pixels = segmentsOf(scene, view);
  expectUnbroken(pixels);
  const ChordError error = chordError(pixels, view);
  EXPECT_LE(error.most, 1e-11);
  EXPECT_EQ(error.seen, 3600u);
}

TEST(CellSegments, AgreeWithEveryCellClippedAtEveryRay) {
  for (const TetMesh& mesh : {box(4, Cut::five, 0.25), ball(6), oGrid(2, 9, 2), stretchedLayers(5, 3.0)}) {
    const PreparedScene scene = smooth(mesh);
    for (const View& view : obliqueViews(40)) {
      const auto pixels = segmentsOf(scene, view);
      for (int y = 0; y < view.height; ++y)
        for (int x = 0; x < view.width; ++x) {
          const Ray ray = rayOf(view, x, y);
          const double origin = dot(view.forward, ray.origin) / dot(view.forward, ray.direction);
          std::vector<Stretch> expected = clipCells(mesh, ray);
          // Corners of cells that a ray misses or meets by a rounding.
          std::erase_if(expected, [](const Stretch& s) { return s.length() < 1e-9; });
          std::vector<CellSegment> found = pixels[static_cast<std::size_t>(y * view.width + x)];
          std::erase_if(found, [](const CellSegment& s) { return s.exit - s.entry < 1e-9; });
          ASSERT_EQ(found.size(), expected.size()) << x << ' ' << y;
          for (std::size_t i = 0; i < found.size(); ++i) {
            ASSERT_EQ(found[i].cell, expected[i].cell);
            EXPECT_NEAR(found[i].entry - origin, expected[i].first, 1e-11);
            EXPECT_NEAR(found[i].exit - origin, expected[i].last, 1e-11);
            const double scalar =
                scalarIn(mesh, expected[i].cell, scene.scalars, ray.origin + expected[i].last * ray.direction);
            EXPECT_NEAR(found[i].scalarExit, scalar, 1e-10);
          }
        }
    }
  }
}

TEST(CellSegments, OverlappingCellsCountOnce) {
  // Two boxes that share a part, each of one field: the union's length, as the k-buffer's inside-count has it.
  TetMesh mesh = box(3);
  TetMesh other = box(4);
  for (Vec3& p : other.points) p += Vec3{0.7, 0.3, 0.4};
  const PreparedScene scene = smooth(merged(mesh, other));
  for (const View& view : obliqueViews(50)) {
    const auto pixels = segmentsOf(scene, view);
    for (int y = 0; y < view.height; ++y)
      for (int x = 0; x < view.width; ++x) {
        const Ray ray = rayOf(view, x, y);
        const Stretch a = throughBox(ray, Vec3(-1.0), Vec3(1.0));
        const Stretch b = throughBox(ray, {-0.3, -0.7, -0.6}, {1.7, 1.3, 1.4});
        double overlap = std::min(a.last, b.last) - std::max(a.first, b.first);
        if (a.length() == 0 || b.length() == 0) overlap = 0;
        const double expected = a.length() + b.length() - std::max(0.0, overlap);
        EXPECT_NEAR(lengthOf(pixels[static_cast<std::size_t>(y * view.width + x)]), expected, 1e-11);
      }
  }
}

TEST(CellSegments, AreTheSameForAnyTilesAndThreads) {
  const PreparedScene scene = smooth(ball(8));
  for (const View& view : {viewOf(false, {1.5, 0.4, 1.1}, {0, 0, 0}, 0.8, 101, 67), obliqueViews(90)[1]}) {
    auto drawn = [&](int side, double most, std::size_t threads) {
      const ThreadLimit limit(threads);
      return referencePixels(scene, view, {side, most});
    };
    const auto pixels = drawn(32, 1e6, 1);
    EXPECT_EQ(pixels, drawn(32, 1e6, 4));
    for (const int side : {1, 3, 16, 1000}) EXPECT_EQ(pixels, drawn(side, 1e6, 3)) << side;
    EXPECT_EQ(pixels, drawn(32, 40, 3));  // tiles halved down to single pixels
  }
}

// The eye 10^6 radii away: the distance along the ray keeps its digits, as it is taken relative to the mesh.
TEST(CellSegments, OfAFarEye) {
  const PreparedScene scene = smooth(box(4, Cut::six, 0.2));
  const View view = viewOf(false, 1e6 * normalize(Vec3{0.3, 0.5, 1}), {0, 0, 0}, 1.8e-6, 60, 60);
  const auto pixels = segmentsOf(scene, view);
  // The box lies 1e6 from the eye: its place in the picture is known to 1e-10; times slopes as above.
  EXPECT_LE(chordError(pixels, view).most, 1e-8);
}

}  // namespace
}  // namespace havs::test
