// The same picture by different ways: devices, tiles, values of k, the CPU replay of the shaders' own arithmetic in
// double.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "core/arithmetic.h"
#include "gl/drawing.h"
#include "mesh/read.h"
#include "support/gl_test.h"
#include "support/replay.h"
#include "transfer/preintegration.h"

namespace havs::test {
namespace {

TetMesh smoothBall() {
  TetMesh mesh = ball(8);
  auto values = smoothField(mesh.points);
  return withPointField(std::move(mesh), std::move(values));
}

Scene ballScene() {
  Scene scene;
  scene.width = scene.height = 160;
  return scene;
}

class KBufferAgreement : public FramebufferFetch {};

TEST_P(KBufferAgreement, SameForEveryKWhenTheOrderIsRight) {
  Scene scene = ballScene();
  scene.k = 14;
  const Image many = draw(*device_, scene, smoothBall()).image;
  for (int k = 1; k < 14; ++k) {
    scene.k = k;
    // The same segments in the same order, up to swaps of fragments a rounding apart.
    EXPECT_LE(between(draw(*device_, scene, smoothBall()).image, many).maximum, 1e-5) << "k " << k;
  }
}

TEST_P(KBufferAgreement, SameTwice) {
  const Scene scene = ballScene();
  EXPECT_EQ(draw(*device_, scene, smoothBall()).image.rgba, draw(*device_, scene, smoothBall()).image.rgba);
}

TEST_P(KBufferAgreement, TilesMakeTheWholePicture) {
  const Scene scene = ballScene();
  StageTimes stages;
  const PreparedScene prepared = prepareScene(scene, smoothBall(), stages);
  const View view = makeView(scene.camera, prepared.frame, scene.width, scene.height);
  RenderPlan chosen = plan(scene, prepared.facts(), capabilitiesOf(*device_));
  const Image whole = makeRenderer(prepared, chosen, stages)->draw(view, stages).image;
  chosen.tileWidth = 64;  // neither divides 160
  chosen.tileHeight = 50;
  const havs::Drawing tiled = makeRenderer(prepared, chosen, stages)->draw(view, stages);
  EXPECT_EQ(tiled.tiles, 12u);
  const auto mask = boundaryEdgeMask(prepared.points, prepared.faces, view);
  // The corners of the faces are rounded differently in each tile's coordinates.
  EXPECT_LE(between(tiled.image, whole, 1e-4, mask).maximum, 1e-4);
}

TEST_P(KBufferAgreement, ShaderAgainstItsOwnArithmeticInDouble) {
  for (auto projection : {Projection::perspective, Projection::orthographic})
    for (const char* sort : {"topological", "centroid"}) {
      Scene scene = ballScene();
      scene.camera.projection = projection;
      scene.sort = sort;
      scene.lookup = "post";
      const Drawing drawing = draw(*device_, scene, smoothBall());
      const PreparedScene& prepared = drawing.prepared;

      FaceOrder order;
      sortMethod(sort)
          .make({prepared.points, prepared.mesh.tetrahedra, &prepared.faces})
          ->sort(viewPointOf(drawing.view), order);
      const std::vector<double> scalars(prepared.scalars.begin(), prepared.scalars.end());
      using A = Arithmetic<DoubleLane>;
      auto end = [&](double s) {
        const auto knot = prepared.curve.at(s);
        return A::Rgba(knot.color[0], knot.color[1], knot.color[2], knot.kappa);
      };
      const ReplayResult replayed = replay({prepared.points, &prepared.faces, order.faces, scalars, drawing.view},
                                           scene.k, [&](double front, double back, double length) {
                                             const A::Rgba c = A::trapezoidSegment(end(front), end(back), length);
                                             return Rgba{c.r, c.g, c.b, c.a};
                                           });
      Image expected = drawing.image;
      for (std::size_t i = 0; i < replayed.image.size(); ++i)
        for (std::size_t c = 0; c < 4; ++c) expected.rgba[4 * i + c] = static_cast<float>(replayed.image[i][c]);
      const Difference difference = between(drawing.image, expected, 1e-3, maskOf(drawing));
      // Float interpolation on faces seen nearly edge on: few pixels, and bounded by the colour's change over a cell.
      EXPECT_LE(difference.beyond, 3u) << sort << ": " << difference;
      const Difference most = between(drawing.image, expected, 2e-5, maskOf(drawing));
      EXPECT_LE(most.beyond, most.compared / 100) << sort << ": " << most;
    }
}

// An annulus whose first and last cells meet in two sets of points at the same places: nothing tells that they are
// neighbours.
TEST_P(KBufferAgreement, SeamOfAnOGrid) {
  const TransferFile transfer(constantTransfer(1.0));
  for (const char* sort : {"topological", "centroid"}) {
    Scene scene = ballScene();
    scene.transferFunction = transfer.path();
    scene.lookup = "post";
    scene.sort = sort;
    TetMesh mesh = oGrid(6, 48, 6);
    auto values = constantField(mesh.points, 0.5);
    const Drawing drawing = draw(*device_, scene, withPointField(std::move(mesh), std::move(values)));
    const PreparedScene& prepared = drawing.prepared;
    FaceOrder order;
    sortMethod("exact")
        .make({prepared.points, prepared.mesh.tetrahedra, &prepared.faces})
        ->sort(viewPointOf(drawing.view), order);
    const ReplayResult exact = replay({prepared.points, &prepared.faces, order.faces, {}, drawing.view}, 14,
                                      constantExtinction(prepared.frame.radius));
    const Difference difference = againstOpacity(
        drawing,
        [&](int x, int y) {
          return exact.image[static_cast<std::size_t>(y) * static_cast<std::size_t>(scene.width) +
                             static_cast<std::size_t>(x)][3];
        },
        1e-4);
    EXPECT_LE(difference.maximum, 1e-4) << sort << ": " << difference;
    EXPECT_EQ(exact.misordered, 0u) << "the replay itself must be right";
  }
}

TEST_P(KBufferAgreement, PaperPresetIsNearTheFloatTable) {
  Scene scene = ballScene();
  scene.lookup = "3d";
  const Image exact = draw(*device_, scene, smoothBall()).image;
  applyPaperPreset(scene);
  const Difference difference = between(draw(*device_, scene, smoothBall()).image, exact, 0.1);
  // 8 bits a segment: half a level of each of some 40 segments.
  EXPECT_LE(difference.maximum, 40 * 0.5 / 255) << difference;
  EXPECT_GT(difference.maximum, 1e-3) << "an 8-bit table cannot be as good as a float one";
}

HAVS_FOR_EVERY_DEVICE(KBufferAgreement);

TEST(KBufferDevices, BluntFinIsTheSameOnEach) {
  const std::string file = HAVS_SHARED_DATA "/bluntfinxyz.bin";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << "no " << file;
  Scene scene;
  scene.width = scene.height = 512;
  const TetMesh mesh = readMesh(file);
  const Xvfb xServer;
  std::vector<Image> images;
  for (const DeviceRow& row : deviceRows()) {
    const auto device = makeTestDevice(row.name);
    images.push_back(draw(*device, scene, mesh).image);
  }
  ASSERT_GE(images.size(), 2u);
  for (std::size_t i = 1; i < images.size(); ++i)
    EXPECT_LE(between(images[i], images[0]).maximum, 1e-5) << deviceRows()[i].name;
}

}  // namespace
}  // namespace havs::test
