// Cameras that show nothing sensible: refused, by name.
#include <limits>

#include "hard/camera_case.h"

namespace havs::test {
namespace {

class CamerasRefused : public CameraCase {
 protected:
  void expectRefusedWith(const std::function<void(Camera&)>& change, const std::string& says) {
    Scene scene = cameraScene({3, 2, 4}, {0, 0, 0}, 30, 16);
    change(scene.camera);
    SCOPED_TRACE(says);
    expectRefused(scene, withSmoothField(box(2)), says);
  }
};

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

TEST_F(CamerasRefused, NumbersThatAreNone) {
  tell({"Cameras", "one NaN in a camera is a picture of NaN, or an empty one", "every number is looked at, and named"});
  for (const double bad : {kNan, kInfinity, -kInfinity}) {
    expectRefusedWith([&](Camera& c) { c.eye = Vec3{0, bad, 1}; }, "camera: eye, target or up is not finite");
    expectRefusedWith([&](Camera& c) { c.target = Vec3{bad, 0, 1}; }, "camera: eye, target or up is not finite");
    expectRefusedWith([&](Camera& c) { c.up = Vec3{0, 0, bad}; }, "camera: eye, target or up is not finite");
    expectRefusedWith([&](Camera& c) { c.azimuth = bad; }, "camera: azimuth or elevation");
    expectRefusedWith([&](Camera& c) { c.elevation = bad; }, "camera: azimuth or elevation");
    expectRefusedWith([&](Camera& c) { c.zoom = bad; }, "camera: zoom");
    expectRefusedWith([&](Camera& c) { c.fieldOfView = bad; }, "camera: the field of view");
    expectRefusedWith([&](Camera& c) { c.viewHeight = bad; }, "camera: the view height");
  }
}

TEST_F(CamerasRefused, EyeAtTheTarget) {
  tell({"Cameras", "the direction of the view is 0 / 0", "refused, also where only rounding makes the two one"});
  expectRefusedWith([](Camera& c) { c.eye = c.target; }, "camera: eye and target are the same point");
  expectRefusedWith(
      [](Camera& c) {
        c.eye = *c.target + Vec3{1e-320, 0, 0};
      },
      "camera: eye and target are the same point");
}

TEST_F(CamerasRefused, FieldsOfViewThatAreNone) {
  tell({"Cameras", "the tangent of 90 degrees is 1.6e16 in double, and of more negative: empty or mirrored pictures",
        "0 and 180 degrees and beyond are refused, and what is wider than 179.99"});
  for (const double angle : {0.0, -1.0, 180.0, 360.0, 1e300})
    expectRefusedWith([&](Camera& c) { c.fieldOfView = angle; }, "camera: the field of view must lie between");
  for (const double angle : {179.99, 179.999999999, 180 - 1e-13})
    expectRefusedWith([&](Camera& c) { c.fieldOfView = angle; }, "camera: the picture shows too much");
}

TEST_F(CamerasRefused, ZoomsThatShowNothing) {
  tell({"Cameras",
        "the height of the view over- or underflows; and before it does, double tells no places apart: with pixels of "
        "1e12 radii the truth was off by 2e-5",
        "a pixel smaller than 1e-12 radii or larger than 1e6 is refused"});
  for (const double zoom : {1e300, 1e30})
    expectRefusedWith([&](Camera& c) { c.zoom = zoom; }, "camera: the picture shows");
  for (const double zoom : {1e-300, 1e-60})
    expectRefusedWith([&](Camera& c) { c.zoom = zoom; }, "camera: the picture shows");
  for (const double height : {1e300, 1e10, 1e-300, 1e-30})
    expectRefusedWith(
        [&](Camera& c) {
          c.projection = Projection::orthographic;
          c.viewHeight = height;
        },
        "camera: the picture shows");
}

TEST_F(CamerasRefused, NumbersOf1e300) {
  tell({"Cameras", "squares of such lengths are infinite, their quotients NaN",
        "lengths are looked at before they are used; directions are scaled before they are squared"});
  expectRefusedWith([](Camera& c) { c.eye = Vec3{1e300, 1e300, -1e300}; }, "camera: the eye is too far away");
  expectRefusedWith([](Camera& c) { c.eye = c.target = Vec3{1e300}; }, "camera: ");
  expectRefusedWith([](Camera& c) { c.target = Vec3{1e300, 0, 0}; }, "camera: ");
}

TEST_F(CamerasRefused, UpOfNoLength) {
  tell({"Cameras", "no direction is up", "refused; lengths of 1e-300 and 1e300 are none the worse for it"});
  expectRefusedWith([](Camera& c) { c.up = Vec3{0}; }, "camera: up has no length");
  const TetMesh mesh = withSmoothField(box(2));
  Scene scene = cameraScene({3, 2, 4}, {0, 0, 0});
  scene.camera.up = Vec3{1, 2, 0};
  const HardPicture plain = expectEveryWay(scene, mesh);
  for (const double scale : {1e-300, 1e300}) {
    scene.camera.up = scale * Vec3{1, 2, 0};
    expectSame("truths of long and short up", expectEveryWay(scene, mesh).truth, plain.truth, 1e-6);
  }
}

}  // namespace
}  // namespace havs::test
