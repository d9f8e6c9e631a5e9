// The tracer itself: it must know an error that no rounding makes from one that the grid makes.
#include "support/pixel_trace.h"

#include <gtest/gtest.h>

#include <cmath>

#include "reference/edge_mask.h"
#include "reference/reference_renderer.h"
#include "support/meshes.h"

namespace havs::test {
namespace {

class Tracer : public testing::Test {
 protected:
  Tracer() {
    TetMesh mesh = ball(6);
    auto values = smoothField(mesh.points);
    mesh.pointFields = {Field{"s", 1, std::move(values)}};
    Scene scene;
    scene.transferFunction = "three-peaks";
    StageTimes stages;
    prepared = prepareScene(scene, std::move(mesh), stages);
    view = makeView(scene.camera, prepared.frame, 60, 60);
    truth = makeReferenceRenderer(prepared)->draw(view, stages).image;
    mask = boundaryEdgeMask(prepared.points, prepared.faces, view);
  }

  PreparedScene prepared;
  View view;
  Image truth;
  std::vector<unsigned char> mask;
};

TEST_F(Tracer, CompositesTheReferenceFromTheFacesOfTheRay) {
  const PixelTracer tracer(prepared, view);
  for (int y = 0; y < 60; y += 3)
    for (int x = 0; x < 60; x += 3) {
      if (mask[static_cast<std::size_t>(60 * y + x)]) continue;
      const PixelTrace trace = tracer.trace(x, y, truth, truth);
      for (int c = 0; c < 4; ++c)
        EXPECT_NEAR(trace.exact.color[static_cast<std::size_t>(c)], truth.pixel(x, y)[c], 1e-7);
      EXPECT_EQ(trace.error, 0);
      EXPECT_EQ(trace.cause, Cause::rounding);
    }
}

TEST_F(Tracer, LeavesWhatIsNoRoundingUnexplained) {
  const PixelTracer tracer(prepared, view);
  Image picture = truth;
  int unexplained = 0;
  for (int y = 5; y < 60; y += 5)
    for (int x = 5; x < 60; x += 5) {
      picture.pixel(x, y)[1] += 1e-3f;
      unexplained += tracer.trace(x, y, picture, truth).cause == Cause::none ? 1 : 0;
    }
  EXPECT_GE(unexplained, 119) << "of 121; beside an edge the grid may move a pixel by so much";
}

TEST_F(Tracer, LateFragmentsComeFirst) {
  EXPECT_EQ(PixelTracer(prepared, view).trace(30, 30, truth, truth, 2).cause, Cause::order);
}

/// Two blocks of cells, of one value each, that meet in a plane x = `meeting` along the view.
PreparedScene twoBlocks(double meeting, Scene& scene) {
  const std::array<double, 3> xs{-1, meeting, 1};
  TetMesh mesh = gridMesh(2, 1, 1, Cut::six, [&](int i, int j, int k) {
    return Vec3{xs[static_cast<std::size_t>(i)], 2.0 * j - 1, 2.0 * k - 1};
  });
  std::vector<double> values;
  for (const Tetrahedron& cell : mesh.tetrahedra) {
    double sum = 0;
    for (const Index p : cell) sum += mesh.points[p].x - meeting;
    values.push_back(sum < 0 ? 0.1 : 0.9);
  }
  mesh.cellFields = {Field{"c", 1, std::move(values)}};
  scene.camera = {.projection = Projection::orthographic, .azimuth = 0, .elevation = 0};
  StageTimes stages;
  return prepareScene(scene, std::move(mesh), stages);
}

/// The plane lies 0.4/256 pixel to the right of a pixel's centre: the reference sees the left block there, and a
/// rasteriser, for which it lies on the centre, may see the right one. 1.4/256 pixel away it may not.
TEST(TracerOfCellData, KnowsWhatTheGridShows) {
  constexpr int kSize = 101;
  for (const double steps : {0.4, 1.4}) {
    Scene scene;
    const View centred = makeView(Camera{.projection = Projection::orthographic, .azimuth = 0, .elevation = 0},
                                  twoBlocks(0, scene).frame, kSize, kSize);
    const double pixel = 2 * centred.halfWidth / kSize * std::sqrt(3.0);  // in mesh units: the radius is sqrt 3
    const PreparedScene prepared = twoBlocks(steps / 256 * pixel, scene);
    const View view = makeView(scene.camera, prepared.frame, kSize, kSize);
    StageTimes stages;
    const Image truth = makeReferenceRenderer(prepared)->draw(view, stages).image;
    const int x = kSize / 2, y = 41;
    Image picture = truth;
    std::copy_n(truth.pixel(x + 3, y), 4, picture.pixel(x, y));

    const PixelTrace trace = PixelTracer(prepared, view).trace(x, y, picture, truth);
    EXPECT_GT(trace.error, 0.01);
    EXPECT_EQ(trace.cause, steps < 1 ? Cause::grid : Cause::none) << summary(trace) << listOf(trace.exact);
    EXPECT_NEAR(256 * trace.nearestEdge(), steps, 0.01);
  }
}

}  // namespace
}  // namespace havs::test
