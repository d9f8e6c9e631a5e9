// Clipped meshes, and cameras in the mesh: pictures against closed forms and the reference, by every method of OpenGL
// and by the native device.
#include <fmt/format.h>

#include "gl/drawing.h"
#include "reference/reference_renderer.h"
#include "render/devices.h"
#include "scene/eye_cut.h"
#include "support/gl_test.h"

namespace havs::test {
namespace {

constexpr double kKappa = 0.8;   // per mesh unit
constexpr double kFloat = 1e-5;  // float distances and some tens of segments composited in float

TetMesh constantBox(int n = 4, double jitter = 0.2) {
  TetMesh mesh = box(n, Cut::six, jitter);
  auto values = constantField(mesh.points, 0.5);
  return withPointField(std::move(mesh), std::move(values));
}

TetMesh smoothBox() {
  TetMesh mesh = box(5, Cut::six, 0.25, 3);
  auto values = smoothField(mesh.points);
  return withPointField(std::move(mesh), std::move(values));
}

Drawing drawNative(const Scene& scene, TetMesh mesh) {
  StageTimes stages;
  Drawing drawing{prepareScene(scene, std::move(mesh), stages), {}, {}, {}};
  drawing.view = makeView(scene.camera, drawing.prepared.frame, scene.width, scene.height);
  const RenderPlan chosen = plan(scene, drawing.prepared.facts(), openRenderDevice("native").capabilities);
  drawing.image = makeRenderer(drawing.prepared, chosen, stages)->draw(drawing.view, stages).image;
  return drawing;
}

Image truthOf(const Drawing& drawing) {
  StageTimes stages;
  return makeReferenceRenderer(drawing.prepared)->draw(drawing.view, stages).image;
}

class Clipping : public FramebufferFetch {
 protected:
  Clipping() { scene_.width = scene_.height = 120; }

  /// Looks at a scene drawn by each method on OpenGL, and by the native device.
  template <class Look>
  void drawEach(const TetMesh& mesh, const Look& look) {
    for (const VisibilityMethod& method : visibilityMethods()) {
      scene_.visibility = method.name;
      look(draw(*device_, scene_, mesh), method.name + " on OpenGL");
    }
    scene_.visibility = "kbuffer";
    look(drawNative(scene_, mesh), std::string("native"));
  }

  Scene scene_;
};

TEST_P(Clipping, OfAConstantBoxIsTheClosedForm) {
  const TransferFile transfer(constantTransfer(kKappa));
  scene_.transferFunction = transfer.path();
  scene_.lookup = "post";
  scene_.clipPlanes = {{{0.3, 0, 0}, {-1, 0, 0}}};
  const Vec3 low(-0.6, -0.5, 0.1), high(0.2, 2, 0.8);
  scene_.clipBoxes = {{low, high, false}, {{-3, -0.9, -3}, {3, 3, 3}}};
  drawEach(constantBox(), [&](const Drawing& drawing, const std::string& by) {
    const Difference difference = againstOpacity(drawing, [&](int x, int y) {
      const Ray ray = rayOf(drawing, x, y);
      const double length = lengthInBox(ray, {-1, -0.9, -1}, {0.3, 1, 1}) - lengthInBox(ray, low, {0.2, 1, 0.8});
      return -std::expm1(-kKappa * length);
    });
    EXPECT_LE(difference.maximum, kFloat) << by << ": " << difference;
    EXPECT_GT(difference.compared, drawing.image.rgba.size() / 8) << by;
  });
}

// What float leaves outside the mask: tests/image/accuracy_test.cpp finds 1e-4 at 99.9% of the pixels.
TEST_P(Clipping, IsThePictureOfTheReference) {
  scene_.transferFunction = "three-peaks";
  scene_.lookup = "exact";
  scene_.clipPlanes = {{{0.1, 0, 0}, {-1, 0.2, -0.3}}};
  scene_.clipBoxes = {{{-0.5, -0.4, -0.5}, {0.5, 0.4, 3}, false}};
  drawEach(smoothBox(), [&](const Drawing& drawing, const std::string& by) {
    const Difference difference = between(drawing.image, truthOf(drawing), 1e-4, maskOf(drawing));
    EXPECT_LE(difference.beyond, difference.compared / 1000) << by << ": " << difference;
  });
}

TEST_P(Clipping, OrderOfThePlanesDoesNotMatter) {
  scene_.lookup = "exact";
  scene_.clipPlanes = {{{0.1, 0, 0}, {-1, 0.2, -0.3}}, {{0, 0, 0.2}, {0.1, 0.3, 1}}, {{0, -0.4, 0}, {0.2, 1, 0.1}}};
  const Drawing one = drawNative(scene_, smoothBox());
  std::swap(scene_.clipPlanes[0], scene_.clipPlanes[2]);
  const Drawing other = drawNative(scene_, smoothBox());
  EXPECT_LE(between(one.image, other.image).maximum, kFloat);
  EXPECT_GT(*std::max_element(one.image.rgba.begin(), one.image.rgba.end()), 0.5);
}

TEST_P(Clipping, OfEverythingIsAnEmptyPicture) {
  scene_.lookup = "exact";
  scene_.clipPlanes = {{{5, 0, 0}, {1, 0, 0}}};
  drawEach(smoothBox(), [&](const Drawing& drawing, const std::string& by) {
    EXPECT_EQ(drawing.image.rgba, std::vector<float>(4 * 120 * 120, 0.0f)) << by;
    EXPECT_EQ(truthOf(drawing).rgba, drawing.image.rgba) << by;
  });
}

/// Eyes in a cell, on a point, an edge and a face of the grid, on a side and a corner of the box, and just off them.
std::vector<Vec3> eyesInTheBox() {
  return {{0.13, 0.21, -0.17},  {0, 0, 0},
          {0.25, 0, 0},         {0.25, 0.25, 0},
          {0.2, 0.3, 0},        {1, 0.1, 0.2},
          {-1, -0.5, 0.5},      {1, 1, 1},
          {1, 0.5, 1},          {1 + 1e-9, 0.1, 0.2},
          {1 - 1e-9, 0.1, 0.2}, {1e-9, 0, 0},
          {0, 0.5 + 1e-7, 0.3}, {1 + 1e-5, 0.1, 0.2},
          {1.0001, 0.1, 0.2},   {1.01, 0.1, 0.2},
          {1.1, 0.9, 0.2}};
}

// Constant extinction: opacity follows from the way that the ray still has in the box. It is off by what is left out
// before the cut, and by what float leaves of distances: they are depths times the ray's length for one unit of depth.
// OpenGL knows places in float, so that 0.1% of the pixels may be off where the eye lies on a side of the box; `cells`
// finds the end of a cell from its planes, in float too, and is off in twice as many.
TEST_P(Clipping, EyesInTheBoxSeeTheRestOfTheirRays) {
  const TransferFile transfer(constantTransfer(kKappa));
  scene_.transferFunction = transfer.path();
  scene_.lookup = "post";
  scene_.width = scene_.height = 64;
  const TetMesh mesh = constantBox(4, 0);
  for (const Vec3& eye : eyesInTheBox())
    for (const double fieldOfView : {1.0, 60.0, 170.0})
      for (const Vec3& direction : {Vec3{-1, -0.2, 0.1}, Vec3{1, 0.3, 0.2}, Vec3{-1, 0, 0}}) {
        scene_.camera.eye = eye;
        scene_.camera.target = eye + direction;
        scene_.camera.fieldOfView = fieldOfView;
        const auto look = [&](const Drawing& drawing, double distance, std::size_t most, const std::string& by) {
          const auto expected = [&](int x, int y) {
            const auto [first, last] = throughBox(rayOf(drawing, x, y), Vec3(-1.0), Vec3(1.0));
            return -std::expm1(-kKappa * std::max(0.0, last - std::max(first, 0.0)));
          };
          const double corner = drawing.view.rayScale(0.5, 0.5);
          const double cut = kKappa * drawing.prepared.frame.radius * distance * corner;
          const Difference difference = againstOpacity(drawing, expected, kFloat * corner + cut);
          EXPECT_LE(difference.beyond, most)
              << fmt::format("{}, eye {} {} {} to {} {} {}, {} degrees: ", by, eye.x, eye.y, eye.z, direction.x,
                             direction.y, direction.z, fieldOfView)
              << difference;
        };
        drawEach(mesh, [&](const Drawing& drawing, const std::string& by) {
          if (by != "native") return look(drawing, kEyeCutInFloat.distance, by.starts_with("cells") ? 8 : 4, by);
          look(drawing, kEyeCutInDouble.distance, 0, by);
          Drawing truth = drawing;
          truth.image = truthOf(drawing);
          look(truth, 0, 0, "reference");
        });
      }
}

INSTANTIATE_TEST_SUITE_P(Devices, Clipping, testing::Values("osmesa"),
                         [](const auto& suiteInfo) { return suiteInfo.param; });

}  // namespace
}  // namespace havs::test
