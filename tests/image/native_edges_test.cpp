// Rays that meet edges, points and planes of the mesh exactly: the native device and the reference share one exact
// rule, so that even here the same faces are met. Faces seen edge on up to rounding are met anywhere along their
// length; the order of the faces takes their sides from the same points, so that no fragment comes late.
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

/// No fragment late, and the picture the reference's.
void expectTrue(const NativeScene& scene) {
  Scene asked = scene.scene;
  asked.certificate = true;
  const havs::Drawing drawing = scene.drawAs(asked);
  EXPECT_EQ(drawing.certificate->misordered, 0u);
  const Comparison comparison = compareImages(drawing.image, scene.truth());
  EXPECT_LE(comparison.rgba.rmse, 1e-6);
  EXPECT_LE(comparison.rgba.max, 1e-5) << "at " << comparison.worstX << ',' << comparison.worstY;
}

TEST(NativeEdges, GridSeenAlongAnAxisWithCentresOnItsEdges) {
  for (const Cut cut : {Cut::five, Cut::six})
    for (int axis = 0; axis < 3; ++axis)
      for (const int size : {41, 40}) {  // odd: a pixel's centre lies on the axis, and others on the grid
        SCOPED_TRACE(std::to_string(size) + " axis " + std::to_string(axis));
        expectTrue({alongAnAxis(size, 32, axis), withSmoothPoints(box(8, cut))});
        // Of fragments of one distance the last in order says whose cell follows.
        expectTrue({alongAnAxis(size, 32, axis), withSmoothCells(box(4, cut))});
      }
}

/// Diagonals of cells through the centres of pixels, seen along them.
TEST(NativeEdges, PixelsOnTheDiagonalsOfCells) {
  for (int axis = 0; axis < 3; ++axis) expectTrue({alongAnAxis(8, 8, axis), withSmoothPoints(box(4, Cut::six))});
}

TEST(NativeEdges, CellsSmallerThanPixels) { expectTrue({alongAnAxis(21, 8, 2), withSmoothPoints(box(16))}); }

/// Two boxes that touch in a plane through the eye.
TEST(NativeEdges, EyeInThePlaneOfFaces) {
  Scene scene;
  scene.lookup = "exact";
  scene.width = scene.height = 101;
  for (const Vec3 eye : {Vec3{0, 0.1, 5}, Vec3{0, 0, 5}, Vec3{1, 1, 4}, Vec3{-1, 0.3, 3}}) {
    scene.camera.eye = eye;
    scene.camera.target = Vec3{0, 0, 0};
    expectTrue({scene, withSmoothPoints(box(2, Cut::six))});
    expectTrue({scene, withSmoothPoints(twoBoxes(2, 0))});
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
  expectTrue({scene, mesh});
  scene.camera.target = Vec3{0, 0, 0.25};  // the edge along z on the centre of a pixel
  expectTrue({scene, mesh});
}

TEST(NativeEdges, CurvedMeshesAlongAnAxis) {
  Scene scene = alongAnAxis(160, 160, 2);
  expectTrue({scene, withSmoothPoints(ball(8))});
  expectTrue({scene, withSmoothPoints(nestedShells(5))});
  expectTrue({scene, withSmoothPoints(oGrid(5, 40, 5))});
}

}  // namespace
}  // namespace havs::test
