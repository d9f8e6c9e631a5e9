// Pixel centres exactly on points and edges of the mesh.
#include "hard/camera_case.h"

namespace havs::test {
namespace {

class CamerasOnGrid : public CameraCase {
 protected:
  /// [-1, 1]^3 along an axis, a cell `pixels` wide; `size` odd: pixel centres on the axis.
  static Scene alongAxis(int axis, int size, double pixelsAcross) {
    Scene scene = cameraScene({}, {0, 0, 0}, 30, size);
    scene.camera.eye.reset();
    scene.camera.projection = Projection::orthographic;
    scene.camera.azimuth = axis == 0 ? 90 : 0;
    scene.camera.elevation = axis == 1 ? 90 : 0;
    scene.camera.viewHeight = 2.0 * size / pixelsAcross;
    return scene;
  }
};

TEST_F(CamerasOnGrid, ParallelAlongTheAxes) {
  tell({"Cameras", "whole faces are seen edge on, and rays run along edges and through points: a gap, or a cell twice",
        "a ray on an edge counts as moved by an infinitesimal, in the picture and in the order of the faces"});
  for (const Cut cut : {Cut::five, Cut::six})
    for (int axis = 0; axis < 3; ++axis) {
      SCOPED_TRACE(axis);
      const TetMesh mesh = withSmoothField(box(4, cut));
      expectEveryWay(alongAxis(axis, 41, 32), mesh);
      expectClosedForm(alongAxis(axis, 41, 32), mesh);
    }
}

TEST_F(CamerasOnGrid, ParallelAlongADiagonal) {
  tell({"Cameras", "along the diagonal that six cells of each cube share, rays run in that edge",
        "a ray on an edge counts as moved by an infinitesimal, in the picture and in the order of the faces"});
  Scene scene = cameraScene({5, 5, 5}, {0, 0, 0}, 30, 65);
  scene.camera.projection = Projection::orthographic;
  const TetMesh mesh = withSmoothField(box(4));
  expectEveryWay(scene, mesh);
  expectClosedForm(scene, mesh);
}

TEST_F(CamerasOnGrid, PerspectiveThroughPointsAndEdges) {
  tell({"Cameras", "rays of a perspective view through points of the mesh, one of them along an edge for its whole way",
        "a ray on an edge counts as moved by an infinitesimal, in the picture and in the order of the faces"});
  // From 4 before the front side, 33 pixels of 1/16: their centres are on multiples of 1/16 there.
  Scene scene = cameraScene({0, 0, 5}, {0, 0, 0}, 2 * std::atan(33.0 / 128) * 180 / std::numbers::pi, 33);
  for (const Cut cut : {Cut::five, Cut::six}) {
    const TetMesh mesh = withSmoothField(box(4, cut));
    expectEveryWay(scene, mesh);
    expectClosedForm(scene, mesh);
  }
}

TEST_F(CamerasOnGrid, PixelsAsLargeAsCells) {
  tell({"Cameras", "every pixel's ray runs through a point of every layer of the mesh",
        "a ray on an edge counts as moved by an infinitesimal, in the picture and in the order of the faces"});
  const TetMesh mesh = withSmoothField(box(8));
  for (int axis = 0; axis < 3; ++axis) {
    expectEveryWay(alongAxis(axis, 13, 8), mesh);
    expectClosedForm(alongAxis(axis, 13, 8), mesh);
  }
}

TEST_F(CamerasOnGrid, CellDataAlongTheAxes) {
  tell({"Cameras", "where a ray runs in an edge, several cells may say what the field is there",
        "the cell that a ray beside it is in, by the same rule for all: one side of a jump or the other"});
  TetMesh mesh = box(3);
  std::vector<double> values(mesh.tetrahedra.size());
  for (std::size_t c = 0; c < values.size(); ++c) values[c] = static_cast<double>(c % 7) / 6;
  mesh.cellFields = {Field{"s", 1, values}};
  for (int axis = 0; axis < 3; ++axis) {
    SCOPED_TRACE(axis);
    expectEveryWay(alongAxis(axis, 33, 24), mesh);
  }
}

}  // namespace
}  // namespace havs::test
