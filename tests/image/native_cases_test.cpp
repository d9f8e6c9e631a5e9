// What else the native device draws, against the reference, every pixel: kinds of data, surfaces, meshes and pictures.
#include <cmath>

#include "image/native_scene.h"
#include "support/meshes.h"

namespace havs::test {
namespace {

/// Roundings: a ray has some tens of segments, each is off by some 2^-24 of numbers of order 1.
constexpr double kFloat = 1e-5;

Scene exactScene(int width = 150, int height = 110) {
  Scene scene;
  scene.lookup = "exact";
  scene.width = width;
  scene.height = height;
  return scene;
}

void expectTrue(const NativeScene& scene) {
  const Comparison comparison = scene.againstTruth();
  EXPECT_LE(comparison.rgba.rmse, 1e-6);
  EXPECT_LE(comparison.rgba.max, kFloat) << "at " << comparison.worstX << ',' << comparison.worstY;
}

double mostOpacity(const Image& image) {
  double most = 0;
  for (std::size_t i = 3; i < image.rgba.size(); i += 4) most = std::max<double>(most, image.rgba[i]);
  return most;
}

TEST(NativeCases, CellData) {
  for (const Projection projection : {Projection::perspective, Projection::orthographic}) {
    Scene scene = exactScene();
    scene.camera.projection = projection;
    expectTrue({scene, withSmoothCells(box(5, Cut::five, 0.2, 5))});
    expectTrue({scene, withSmoothCells(nestedShells(3))});
  }
}

TEST(NativeCases, TouchingBoxesAndGaps) {
  for (const double gap : {0.0, 1e-9, 1e-3, 0.2}) {
    SCOPED_TRACE(gap);
    expectTrue({exactScene(), withSmoothPoints(twoBoxes(3, gap))});
  }
}

/// Opaque at all scalars beyond a plateau: rays end on a surface.
TEST(NativeCases, OpaqueSurfaces) {
  Scene scene = exactScene();
  scene.transferFunction = "plateau-opaque";
  const NativeScene drawn(scene, withSmoothPoints(ball(6)));
  ASSERT_TRUE(drawn.prepared.facts().opaqueSurfaces);
  const Image truth = drawn.truth();
  EXPECT_EQ(mostOpacity(truth), 1);
  // A ray that grazes the surface meets it or misses it by a rounding of its scalar: fewer than one pixel of a
  // thousand.
  const Comparison comparison = compareImages(drawn.draw().image, truth);
  EXPECT_LE(comparison.rgba.p999, kFloat);
}

TEST(NativeCases, EarlyTerminationLosesAtMostWhatIsBehind) {
  Scene scene = exactScene();
  scene.unitLength = 0.03;  // dense
  const NativeScene drawn(scene, withSmoothPoints(ball(6)));
  const Image whole = drawn.draw().image;
  ASSERT_GT(mostOpacity(whole), 0.995);
  for (const double opacity : {0.3, 0.8, 0.99}) {
    Scene early = scene;
    early.earlyTermination = opacity;
    const Comparison comparison = compareImages(drawn.drawAs(early).image, whole);
    EXPECT_LE(comparison.rgba.max, 1 - opacity + 1e-6) << opacity;
    EXPECT_GT(comparison.rgba.max, 0) << opacity;
  }
}

/// With no late fragment there is nothing that could be composited instead of dropped.
TEST(NativeCases, CompositingLateFragmentsChangesNothingElse) {
  Scene scene = exactScene();
  scene.certificate = true;
  const NativeScene drawn(scene, withSmoothPoints(box(5, Cut::six, 0.25)));
  const havs::Drawing dropped = drawn.draw();
  EXPECT_EQ(dropped.certificate->misordered, 0u);
  scene.compositeLate = true;
  EXPECT_EQ(differenceInBits(drawn.drawAs(scene), dropped), "");
  scene.sort = "none";
  const havs::Drawing paper = drawn.drawAs(scene);
  scene.compositeLate = false;
  const havs::Drawing ours = drawn.drawAs(scene);
  EXPECT_GT(ours.certificate->misordered, 0u);
  EXPECT_NE(differenceInBits(paper.image, ours.image), "");
}

TEST(NativeCases, SingleTetrahedron) {
  for (const int azimuth : {0, 45, 90, 200}) {
    Scene scene = exactScene();
    scene.camera.azimuth = azimuth;
    scene.unitLength = 0.05;
    TetMesh mesh = singleTetrahedron();
    mesh.pointFields = {Field{"s", 1, linearField(mesh.points, {0.4, -0.2, 0.1})}};
    const NativeScene drawn(scene, mesh);
    EXPECT_GT(mostOpacity(drawn.draw().image), 0.05);
    expectTrue(drawn);
  }
}

TEST(NativeCases, PicturesOfAnySize) {
  for (const auto& [width, height] : {std::pair{1, 1}, {3, 5}, {4097, 2}, {2, 4097}, {65, 64}}) {
    SCOPED_TRACE(std::to_string(width) + "x" + std::to_string(height));
    const NativeScene drawn(exactScene(width, height), withSmoothPoints(box(3, Cut::six, 0.2)));
    EXPECT_GT(mostOpacity(drawn.draw().image), 0);
    expectTrue(drawn);
  }
}

TEST(NativeCases, NothingBeforeTheCamera) {
  Scene scene = exactScene();
  scene.certificate = true;
  scene.camera.eye = Vec3{0, 0, 9};
  scene.camera.target = Vec3{0, 0, 20};
  const havs::Drawing drawing = NativeScene(scene, withSmoothPoints(box(3))).draw();
  for (const float number : drawing.image.rgba) EXPECT_EQ(number, 0.0f);
  EXPECT_EQ(drawing.certificate->fragments, 0u);
  EXPECT_EQ(drawing.certificate->misordered, 0u);
}

}  // namespace
}  // namespace havs::test
