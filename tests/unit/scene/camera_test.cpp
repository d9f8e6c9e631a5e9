#include "scene/camera.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "core/error.h"

namespace havs {
namespace {

const LocalFrame kFrame{{10, 20, 30}, 5.0, 10.0};

Camera angles(double azimuth, double elevation) {
  Camera camera;
  camera.azimuth = azimuth;
  camera.elevation = elevation;
  return camera;
}

// Rounding of a handful of double operations on numbers of order 1.
constexpr double kRounding = 1e-12;

void expectNear(const Vec3& a, const Vec3& b, double bound = kRounding) {
  EXPECT_LE(length(a - b), bound) << a.x << "," << a.y << "," << a.z << " against " << b.x << "," << b.y << "," << b.z;
}

TEST(Camera, AzimuthZeroLooksAlongMinusZ) {
  const View view = makeView(angles(0, 0), kFrame, 100, 100);
  expectNear(view.forward, {0, 0, -1});
  expectNear(view.right, {1, 0, 0});
  expectNear(view.up, {0, 1, 0});
}

TEST(Camera, AxesAreOrthonormalFromEverywherePolesIncluded) {
  for (double azimuth = -180; azimuth <= 180; azimuth += 30)
    for (double elevation = -90; elevation <= 90; elevation += 15) {
      const View view = makeView(angles(azimuth, elevation), kFrame, 300, 200);
      expectNear(cross(view.right, view.up), -view.forward);
      EXPECT_NEAR(length(view.right), 1, kRounding);
      EXPECT_NEAR(dot(view.right, view.up), 0, kRounding);
    }
}

TEST(Camera, BoundingSphereFitsTheSmallerSide) {
  for (auto projection : {Projection::perspective, Projection::orthographic})
    for (auto [width, height] : {std::pair{400, 200}, {200, 400}}) {
      Camera camera = angles(30, 20);
      camera.projection = projection;
      const View view = makeView(camera, kFrame, width, height);
      // The silhouette of the unit sphere touches the edge: the ray through the middle of the shorter side's border is
      // tangent to it.
      const double half = std::min(view.halfWidth, view.halfHeight);
      const double nearest = view.orthographic ? half : length(view.eye) * std::sin(std::atan(half));
      EXPECT_NEAR(nearest, 1.0, kRounding);
    }
}

TEST(Camera, ProjectInvertsTheRaysOfPixels) {
  for (auto projection : {Projection::perspective, Projection::orthographic}) {
    Camera camera = angles(77, -33);
    camera.projection = projection;
    camera.zoom = 1.7;
    const View view = makeView(camera, kFrame, 320, 200);
    const double px = 41.5, py = 150.5;
    const double u = (2 * px / 320 - 1) * view.halfWidth, v = (1 - 2 * py / 200) * view.halfHeight;
    const Vec3 across = u * view.right + v * view.up;
    const Vec3 point =
        view.orthographic ? view.center + across + 0.3 * view.forward : view.eye + 4.0 * (view.forward + across);
    const Vec3 projected = view.project(point);
    EXPECT_NEAR(projected.x, px, 1e-9);  // kRounding times the size of the picture
    EXPECT_NEAR(projected.y, py, 1e-9);
    if (!view.orthographic) {
      const double along = length(point - view.eye);
      EXPECT_NEAR(view.rayScale(px, py) * projected.z, along, 1e-11);
    }
  }
}

TEST(Camera, UpParallelToTheViewStillGivesAFrame) {
  Camera camera;
  camera.eye = Vec3{10, 100, 30};
  camera.up = Vec3{0, 1, 0};
  const View view = makeView(camera, kFrame, 10, 10);
  EXPECT_NEAR(length(view.up), 1, kRounding);
  EXPECT_NEAR(dot(view.up, view.forward), 0, kRounding);
}

TEST(Camera, LengthOfUpDoesNotMatter) {
  Camera camera;
  camera.up = Vec3{1, 2, 0};
  const View view = makeView(camera, kFrame, 10, 10);
  for (const double scale : {1e-200, 1e200}) {
    camera.up = scale * Vec3{1, 2, 0};
    expectNear(makeView(camera, kFrame, 10, 10).up, view.up);
  }
}

TEST(Camera, DescriptionGivesTheSameView) {
  for (auto projection : {Projection::perspective, Projection::orthographic}) {
    Camera camera = parseCamera("30,20,2.5", projection);
    const View a = makeView(camera, kFrame, 640, 480);
    const View b = makeView(parseCamera(describe(camera, kFrame, 640, 480), Projection::perspective), kFrame, 640, 480);
    EXPECT_EQ(a.orthographic, b.orthographic);
    expectNear(a.forward, b.forward);
    expectNear(a.up, b.up);
    EXPECT_NEAR(a.halfWidth, b.halfWidth, kRounding);
  }
}

std::string messageOf(const std::string& text) {
  try {
    makeView(parseCamera(text, Projection::perspective), kFrame, 10, 10);
  } catch (const Error& error) {
    EXPECT_EQ(error.exitStatus(), 2);
    return error.what();
  }
  return "no error";
}

TEST(Camera, BadTextsGetOneClearError) {
  using testing::HasSubstr;
  EXPECT_THAT(messageOf("nan,0"), HasSubstr("cannot read 'nan,0'"));
  EXPECT_THAT(messageOf("30"), HasSubstr("azimuth,elevation"));
  EXPECT_THAT(messageOf("30,20,0"), HasSubstr("zoom must be greater than 0"));
  EXPECT_THAT(messageOf("{\"azimut\": 3}"), HasSubstr("did you mean 'azimuth'"));
  EXPECT_THAT(messageOf("{\"eye\": [1, 2]}"), HasSubstr("'eye' must be three numbers"));
  EXPECT_THAT(messageOf("{\"field_of_view\": 180}"), HasSubstr("between 0 and 180"));
  EXPECT_THAT(messageOf("{\"eye\": [10, 20, 30]}"), HasSubstr("same point"));
  EXPECT_THAT(messageOf("{broken"), HasSubstr("not a JSON object"));
  for (const char* text : {"30,20,", "30,20,1,", "30,,20", "30 20", "30,20x", ",30,20", "1,2,3,4"})
    EXPECT_THAT(messageOf(text), HasSubstr(std::string("cannot read '") + text + "'"));
  EXPECT_THAT(messageOf("{\"eye\": [1e200, 0, 0]}"), HasSubstr("too far away"));
  EXPECT_THAT(messageOf("{\"up\": [0, 0, 0]}"), HasSubstr("up has no length"));
}

}  // namespace
}  // namespace havs
