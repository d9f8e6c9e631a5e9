// Eyes in the bounding sphere but in no cell, in planes of faces, and meshes beside and behind the eye.
#include "hard/camera_case.h"

namespace havs::test {
namespace {

class CamerasBeside : public CameraCase {
 protected:
  void expectIn(const TetMesh& mesh, const Vec3& eye, const Vec3& direction, double fieldOfView) {
    SCOPED_TRACE(testing::Message() << "towards " << direction.x << ' ' << direction.y << ' ' << direction.z);
    const Scene scene = cameraScene(eye, eye + direction, fieldOfView);
    expectEveryWay(scene, mesh, boundsWithin(scene, mesh));
  }
  void expectEmpty(const HardPicture& picture) {
    double most = *std::max_element(picture.truth.rgba.begin(), picture.truth.rgba.end());
    for (const HardDrawing& d : picture.drawings)
      most = std::max<double>(most, *std::max_element(d.drawing.image.rgba.begin(), d.drawing.image.rgba.end()));
    expectAtMost("greatest opacity", most, 0);
  }
};

TEST_F(CamerasBeside, ThroughAHole) {
  tell({"Cameras", "the eye is in the mesh's box, in none of its cells, and flies through its hole",
        "whether the eye is in a cell is found out, not guessed from the box; on OpenGL the mesh is cut where it "
        "passes the eye's plane"});
  const TetMesh mesh = withSmoothField(boxWithHole(6));
  expectIn(mesh, {0.05, -0.02, 0.3}, {0.1, 0.05, -1}, 90);
  expectIn(mesh, {0.05, -0.02, 0.3}, {1, 0.2, -0.1}, 90);
}

TEST_F(CamerasBeside, BetweenTwoParts) {
  tell({"Cameras", "an eye between two parts has one before and one behind it, whose faces project upside down",
        "faces behind the eye are cut away, in homogeneous coordinates or with the mesh"});
  const TetMesh mesh = withSmoothField(twoBoxes(2, 0.5));
  expectIn(mesh, {0.2, 0.3, 0.1}, {1, 0.1, -0.2}, 80);
  expectIn(mesh, {0.2, 0.3, 0.1}, {-0.1, 1, 0.2}, 120);
}

TEST_F(CamerasBeside, InTheHollowOfAShell) {
  tell({"Cameras", "rays from a hollow meet the mesh as an entry though its outside is behind the eye",
        "the count of entries and exits starts at 0 for every eye outside the cells"});
  const TetMesh mesh = withSmoothField(nestedShells(5));
  expectIn(mesh, {0.45, 0.1, 0.05}, {-1, 0.2, 0.1}, 80);
  expectIn(mesh, {0.45, 0.1, 0.05}, {1, -0.2, 0.1}, 80);
}

TEST_F(CamerasBeside, MeshBehindTheEye) {
  tell({"Cameras", "points behind the eye project into the picture, mirrored", "rays begin at the eye"});
  const TetMesh mesh = withSmoothField(box(2));
  for (const Vec3& eye : {Vec3{3, 0.1, 0.2}, Vec3{1.2, 0.1, 0.2}, Vec3{1e6, 2e5, 0}}) {
    SCOPED_TRACE(eye.x);
    const Scene scene = cameraScene(eye, 2.0 * eye, 100);
    expectEmpty(expectEveryWay(scene, mesh, boundsWithin(scene, mesh)));
  }
}

TEST_F(CamerasBeside, MeshPartlyBehindTheEye) {
  tell({"Cameras", "faces through the eye's plane have corners at infinity and beyond",
        "the reference and the native device never divide by the distance; OpenGL clips what is not seen"});
  const TetMesh mesh = withSmoothField(box(3, Cut::six, 0.2));
  for (const Vec3& eye : {Vec3{1.9, 0.1, 0.2}, Vec3{1.4, 0.3, -0.2}}) {  // outside the sphere, and inside
    SCOPED_TRACE(eye.x);
    const Scene scene = cameraScene(eye, eye + Vec3{-0.2, 1, 0.1}, 120);
    expectEveryWay(scene, mesh, boundsWithin(scene, mesh));
    expectClosedForm(scene, mesh);
  }
}

TEST_F(CamerasBeside, InThePlaneOfInnerFacesOutside) {
  tell({"Cameras", "faces in a plane through the eye are seen edge on: lines, with any depth",
        "sides and coverage come from the same exact products, so every ray finds one way through the cells"});
  const TetMesh mesh = withSmoothField(box(4));
  for (const Vec3& eye : {Vec3{0, 0.1, 5}, Vec3{0.5, 0, 5}, Vec3{4, 4, 4}}) {
    SCOPED_TRACE(eye.z);
    const Scene scene = cameraScene(eye, {0, 0, 0}, 35, 65);
    expectEveryWay(scene, mesh);
    expectClosedForm(scene, mesh);
  }
}

TEST_F(CamerasBeside, InThePlaneOfBoundaryFacesOutside) {
  tell({"Cameras", "whether rays along a side of the mesh enter it is decided by rounding",
        "the infinitesimal shift of the fill rule decides, the same way for all faces at an edge"});
  const TetMesh mesh = withSmoothField(box(4));
  for (const Vec3& eye : {Vec3{1, 0.1, 5}, Vec3{1, 1, 4}}) {
    SCOPED_TRACE(eye.y);
    const Scene scene = cameraScene(eye, {1, 0, 0}, 40, 64);
    expectEveryWay(scene, mesh);
    expectClosedForm(scene, mesh);
  }
}

TEST_F(CamerasBeside, UpParallelToTheView) {
  tell({"Cameras", "right is the cross product of the view and up: no length, then NaN",
        "another axis is up where the angle between the two is below 1e-9"});
  const TetMesh mesh = withSmoothField(box(3, Cut::six, 0.2));
  for (const Vec3& up : {Vec3{0, 1, 0}, Vec3{0, -1e200, 0}, Vec3{1e-12, 1, 0}}) {
    Scene scene = cameraScene({0, 5, 0}, {0, 0, 0});
    scene.camera.up = up;
    expectEveryWay(scene, mesh);
    expectClosedForm(scene, mesh);
  }
}

TEST_F(CamerasBeside, UpNearlyParallelToTheView) {
  tell({"Cameras",
        "what is left of the cross product after cancelling has few digits: for an up 1e-8 aside, right was off a "
        "right angle to the view by 1e-9",
        "what of it lies along the view is taken out of it once more"});
  const TetMesh mesh = withSmoothField(box(3, Cut::six, 0.2));
  for (const double angle : {1e-8, 1e-5}) {
    Scene scene = cameraScene({3, 4, 2}, {0, 0, 0});
    scene.camera.up = Vec3{3, 4, 2} + 5.4 * angle * Vec3{0, 0.4, -0.9};
    expectEveryWay(scene, mesh);
    expectClosedForm(scene, mesh);
    const View view = makeView(scene.camera, localFrame(mesh), 64, 64);
    expectAtMost("axes off a right angle",
                 std::max({std::abs(dot(view.right, view.up)), std::abs(dot(view.right, view.forward)),
                           std::abs(dot(view.up, view.forward))}),
                 1e-15);
  }
}

}  // namespace
}  // namespace havs::test
