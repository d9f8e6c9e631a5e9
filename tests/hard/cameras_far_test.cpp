// Eyes and targets far from the mesh.
#include <fmt/format.h>

#include "hard/camera_case.h"

namespace havs::test {
namespace {

class CamerasFar : public CameraCase {
 protected:
  /// The mesh fills the picture from `radii` away.
  static Scene sceneFrom(double radii) {
    Scene scene = cameraScene(radii * std::sqrt(3.0) * normalize(Vec3{2.1, 1.7, 3.2}), Vec3{0});
    scene.camera.fieldOfView = 2 * std::atan(1 / radii) * 180 / std::numbers::pi;
    return scene;
  }
  void expectFrom(double radii) {
    const TetMesh mesh = box(4, Cut::six, 0.2);
    expectEveryWay(sceneFrom(radii), withSmoothField(mesh));
    expectClosedForm(sceneFrom(radii), withSmoothField(mesh));
  }
  CaseStory story(const std::string& radii) const {
    return {"Cameras", "places in the picture are differences from the eye: " + radii,
            "places across the view are relative to a point of its axis near the mesh, depths to the mesh's centre"};
  }
};

TEST_F(CamerasFar, AThousandRadii) {
  tell(story("3 of their digits are gone, half of a float's"));
  expectFrom(1e3);
}

TEST_F(CamerasFar, AMillionRadii) {
  tell(story("6 of their digits are gone, all of a float's; the truth itself was off by 4e-10"));
  expectFrom(1e6);
}

TEST_F(CamerasFar, ABillionRadii) {
  tell(story("9 of their digits are gone; the truth itself was off by 2e-7"));
  expectFrom(1e9);
}

TEST_F(CamerasFar, ATrillionRadii) {
  tell(story("12 of their digits are gone; the truth itself was off by 4e-4, OpenGL from it by 2e-4"));
  expectFrom(1e12);
}

TEST_F(CamerasFar, FartherIsRefused) {
  tell({"Cameras", "products of coordinates leave the range of a float, later of a double: infinities, not pictures",
        "an eye beyond 1e15 radii is refused, also one that a tiny field of view asks for"});
  const TetMesh mesh = withSmoothField(box(2));
  for (const double radii : {1e16, 1e40, 1e150, 1e300}) {
    SCOPED_TRACE(radii);
    expectRefused(sceneFrom(radii), mesh, "camera: the eye is too far away");
  }
  Scene fitted = sceneFrom(4);
  fitted.camera.eye.reset();
  fitted.camera.fieldOfView = 1e-200;
  expectRefused(fitted, mesh, "camera: the eye is too far away");
}

TEST_F(CamerasFar, FieldOfViewJustAboveZero) {
  tell({"Cameras",
        "an eye that a tiny field of view puts 1e14 radii away knows places to 0.01 radii in double: the truth itself "
        "was off by 0.04, OpenGL from it by 0.02",
        "what the picture shows is found from the target, not from the eye"});
  Scene scene = sceneFrom(4);
  scene.camera.eye.reset();
  scene.camera.fieldOfView = 1e-12;
  const TetMesh mesh = withSmoothField(box(4, Cut::six, 0.2));
  expectEveryWay(scene, mesh);
  expectClosedForm(scene, mesh);
}

TEST_F(CamerasFar, Target) {
  tell({"Cameras", "a target far behind the mesh, as a plane of places to be relative to, has no digits left for it",
        "places are relative to the eye or the target, whichever is nearer to the mesh"});
  const Vec3 eye{2.1, 1.7, 3.2};
  const TetMesh mesh = withSmoothField(box(4, Cut::six, 0.2));
  const HardPicture near = expectEveryWay(cameraScene(eye, Vec3{0}, 40), mesh);
  for (const double far : {1e9, 1e15, 1e100}) {
    const HardPicture picture = expectEveryWay(cameraScene(eye, -far * eye, 40), mesh);
    // The direction is rounded once more: 1e-16 times slopes of some 1e3 radii at most.
    expectSame("truths of near and far target", picture.truth, near.truth, 1e-6);
  }
}

TEST_F(CamerasFar, EyeAndTarget) {
  tell({"Cameras", "an eye and a target both far beside the mesh, which fills the picture between them and nothing",
        "the direction is that of their difference; a mesh out of sight is an empty picture"});
  const TetMesh mesh = withSmoothField(box(2));
  const HardPicture picture = expectEveryWay(cameraScene({1e9, 0, 0}, {1e9, 1, 0}), mesh);
  expectAtMost("greatest opacity", *std::max_element(picture.truth.rgba.begin(), picture.truth.rgba.end()), 0);
  // Looking back: the mesh is a millionth of a pixel, between the centres of the middle ones.
  const HardPicture back = expectEveryWay(cameraScene({1e9, 0, 0}, {1e9 - 1, 0, 0}), mesh);
  expectAtMost("greatest opacity", *std::max_element(back.truth.rgba.begin(), back.truth.rgba.end()), 0);
}

}  // namespace
}  // namespace havs::test
