// Rays that meet edges, points and planes of the mesh exactly: the native device and the reference share one exact
// rule, so that even here the same faces are met. But faces seen edge on up to rounding are met anywhere along their
// length, and the order of the faces, which other roundings decide, may have them elsewhere: such fragments come late.
// The certificate counts them, and where it counts none the picture must be right.
#include <algorithm>

#include "image/native_scene.h"
#include "support/meshes.h"

namespace havs::test {
namespace {

/// [-1, 1]^3 seen along z, a cell 4 pixels wide: pixel centres on the mesh's edges and points (`shift` 0) or between.
Scene alongAnAxis(int size, double pixelsAcross, int axis) {
  Scene scene;
  scene.lookup = "exact";
  scene.width = scene.height = size;
  scene.camera = {.projection = Projection::orthographic, .azimuth = 0, .elevation = 0};
  scene.camera.viewHeight = 2.0 * size / pixelsAcross;
  if (axis == 0) scene.camera.azimuth = 90;
  if (axis == 1) scene.camera.elevation = 90;
  return scene;
}

void expectTrueWhereInOrder(const NativeScene& scene, double leastInOrder) {
  Scene asked = scene.scene;
  asked.certificate = true;
  const havs::Drawing drawing = scene.drawAs(asked);
  const auto& count = drawing.certificate->count;
  std::vector<unsigned char> late(count.size());
  std::transform(count.begin(), count.end(), late.begin(), [](std::uint32_t n) { return n > 0 ? 1 : 0; });
  const Comparison comparison = compareImages(drawing.image, scene.truth(), late);
  EXPECT_GE(static_cast<double>(comparison.pixels), leastInOrder * static_cast<double>(count.size()));
  EXPECT_LE(comparison.rgba.rmse, 1e-6);
  EXPECT_LE(comparison.rgba.max, 1e-5) << "at " << comparison.worstX << ',' << comparison.worstY;
}

TEST(NativeEdges, GridSeenAlongAnAxisWithCentresOnItsEdges) {
  for (const Cut cut : {Cut::five, Cut::six})
    for (int axis = 0; axis < 3; ++axis)
      for (const int size : {41, 40}) {  // odd: a pixel's centre lies on the axis, and others on the grid
        SCOPED_TRACE(std::to_string(size) + " axis " + std::to_string(axis));
        expectTrueWhereInOrder({alongAnAxis(size, 32, axis), withSmoothPoints(box(8, cut))}, 0.85);
        // Fragments of one distance may change places, and with them the cell whose value a segment has: beside the
        // edges of cells, then.
        Scene beside = alongAnAxis(size, 32, axis);
        beside.camera.target = Vec3{0.0113, 0.0071, 0.0137};
        expectTrueWhereInOrder({beside, withSmoothCells(box(4, cut))}, 1);
      }
}

TEST(NativeEdges, CellsSmallerThanPixels) {
  expectTrueWhereInOrder({alongAnAxis(21, 8, 2), withSmoothPoints(box(16))}, 0.85);
}

/// Two boxes that touch in a plane through the eye.
TEST(NativeEdges, EyeInThePlaneOfFaces) {
  Scene scene;
  scene.lookup = "exact";
  scene.width = scene.height = 101;
  for (const Vec3 eye : {Vec3{0, 0.1, 5}, Vec3{0, 0, 5}, Vec3{1, 1, 4}, Vec3{-1, 0.3, 3}}) {
    scene.camera.eye = eye;
    scene.camera.target = Vec3{0, 0, 0};
    expectTrueWhereInOrder({scene, withSmoothPoints(box(2, Cut::six))}, 0.85);
    expectTrueWhereInOrder({scene, withSmoothPoints(twoBoxes(2, 0))}, 0.85);
  }
}

/// A tetrahedron whose face is seen exactly edge on, and a ray along one of its edges.
TEST(NativeEdges, FaceSeenEdgeOn) {
  Scene scene;
  scene.lookup = "exact";
  scene.width = scene.height = 33;
  scene.camera = {.projection = Projection::orthographic, .azimuth = 0, .elevation = 0};
  TetMesh mesh = singleTetrahedron();
  mesh.pointFields = {Field{"s", 1, linearField(mesh.points, {0.3, 0.1, -0.2})}};
  expectTrueWhereInOrder({scene, mesh}, 0.85);
  scene.camera.target = Vec3{0, 0, 0.25};  // the edge along z on the centre of a pixel
  expectTrueWhereInOrder({scene, mesh}, 0.85);
}

TEST(NativeEdges, CurvedMeshesAlongAnAxis) {
  Scene scene = alongAnAxis(160, 160, 2);
  expectTrueWhereInOrder({scene, withSmoothPoints(ball(8))}, 0.99);
  expectTrueWhereInOrder({scene, withSmoothPoints(nestedShells(5))}, 0.85);
  expectTrueWhereInOrder({scene, withSmoothPoints(oGrid(5, 40, 5))}, 0.85);
}

}  // namespace
}  // namespace havs::test
