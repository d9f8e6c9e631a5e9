// The mesh's outline, boundary surface and wire frame against the reference, which has the same layers and composites
// them in double: on the native device and by the visibility methods that take layers on OpenGL.
#include <gtest/gtest.h>

#include "gl/device.h"
#include "image/compare.h"
#include "image/meshes_drawn.h"
#include "image/native_scene.h"
#include "reference/edge_mask.h"
#include "render/make_renderer.h"
#include "support/gl_test.h"

namespace havs::test {
namespace {

constexpr int kSize = 256;
/// The layers' colours are the reference's, rounded to float; what remains is as without them
/// (native_accuracy_test.cpp).
constexpr double kNativeRmse = 1e-6, kNativeMaximum = 1e-5;
constexpr double kLitRmse = 1e-5, kLitMaximum = 2e-3;  // light_test.cpp
/// What issue 5 promises of OpenGL.
constexpr double kGlP999 = 5e-3;

struct Setting {
  std::string name;
  std::function<void(Scene&)> apply;
};
void PrintTo(const Setting& setting, std::ostream* stream) { *stream << setting.name; }

void addIsosurface(Scene& scene, const TetMesh& mesh, double opacity) {
  StageTimes stages;
  const auto [low, high] = prepareScene(scene, mesh, stages).curve.domain;
  scene.isosurfaces = {{low + 0.4837 * (high - low), Color{1, 0.5, 0}, opacity}};
}

class OverlaysAgainstReference : public testing::TestWithParam<std::tuple<MeshDrawn, Setting>> {
 protected:
  void SetUp() override {
    auto mesh = std::get<0>(GetParam()).make();
    if (!mesh)
      GTEST_SKIP() << "no such mesh here: TetGen is left out of the build, or there is no " << HAVS_SHARED_DATA;
    mesh_ = std::move(*mesh);
    device_ = makeTestDevice("osmesa");
  }

  Scene sceneWith(const std::string& transfer) const {
    Scene scene;
    scene.transferFunction = transfer;
    scene.lookup = "exact";
    scene.width = scene.height = kSize;
    std::get<1>(GetParam()).apply(scene);
    const std::string& name = std::get<1>(GetParam()).name;
    if (name.find("Isosurface") != std::string::npos) addIsosurface(scene, mesh_, 0.5);
    if (name.find("Clipped") != std::string::npos) {
      StageTimes stages;
      scene.clipPlanes = {{prepareScene(scene, mesh_, stages).frame.center, {1, 0.3, -0.2}}};
    }
    return scene;
  }

  void expectRight(Scene scene) {
    const NativeScene drawn(scene, mesh_);
    const Image truth = drawn.truth();
    scene.overlays = {};
    EXPECT_GT(compareImages(NativeScene(scene, mesh_).truth(), truth).rgba.rmse, 0.01) << "the overlays show";
    scene = drawn.scene;
    const Comparison native = compareImages(drawn.draw().image, truth);
    EXPECT_LE(native.rgba.rmse, scene.lighting ? kLitRmse : kNativeRmse);
    EXPECT_LE(native.rgba.max, scene.lighting ? kLitMaximum : kNativeMaximum)
        << "at " << native.worstX << ',' << native.worstY;
    RecordProperty("native_rmse", std::to_string(native.rgba.rmse * 1e6) + "e-6");
    RecordProperty("native_max", std::to_string(native.rgba.max * 1e6) + "e-6");

    const auto mask = boundaryEdgeMask(drawn.prepared.points, drawn.prepared.faces, drawn.view);
    for (const VisibilityMethod& method : visibilityMethods()) {
      if (!method.takesLayers || (scene.lighting && !method.carriesLight)) continue;
      scene.visibility = method.name;
      StageTimes stages;
      const RenderPlan chosen = plan(scene, drawn.prepared.facts(), capabilitiesOf(*device_));
      const Image picture = makeRenderer(drawn.prepared, chosen, stages)->draw(drawn.view, stages).image;
      const Comparison gl = compareImages(picture, truth, mask);
      EXPECT_LE(gl.rgba.p999, kGlP999) << method.name << " at " << gl.worstX << ',' << gl.worstY;
      RecordProperty(method.name + "_p999", std::to_string(gl.rgba.p999 * 1e6) + "e-6");
      RecordProperty(method.name + "_rmse", std::to_string(gl.rgba.rmse * 1e6) + "e-6");
    }
  }

  TetMesh mesh_;
  std::unique_ptr<Device> device_;
};

TEST_P(OverlaysAgainstReference, Perspective) { expectRight(sceneWith("viridis")); }

TEST_P(OverlaysAgainstReference, Orthographic) {
  Scene scene = sceneWith("three-peaks");  // clear at most scalars: cells are left out, layers are not
  scene.camera.projection = Projection::orthographic;
  scene.camera.azimuth = 200;
  scene.camera.elevation = -35;
  expectRight(scene);
}

TEST_P(OverlaysAgainstReference, EyeInTheMesh) {
  Scene scene = sceneWith("viridis");
  scene.lighting.reset();  // pieces of cells at the eye are lit at more places than whole ones (effects_test.cpp)
  StageTimes stages;
  const LocalFrame frame = prepareScene(scene, mesh_, stages).frame;
  scene.camera.eye = frame.center + 0.3 * frame.radius * Vec3{0.6, 0.2, 0.5};
  expectRight(scene);
}

std::vector<MeshDrawn> someMeshes() {
  std::vector<MeshDrawn> some;
  for (const MeshDrawn& mesh : meshesDrawn())
    if (mesh.name == "Spx" || mesh.name == "BluntFin" || mesh.name == "TetgenTorusKnot") some.push_back(mesh);
  return some;
}

std::vector<Setting> settings() {
  const auto outline = [](Scene& scene) { scene.overlays.outline = Outline{{0, 0.5, 1}, 3}; };
  const auto surface = [](double opacity) {
    return [=](Scene& scene) { scene.overlays.surface = BoundarySurface{{0.9, 0.7, 0.4}, opacity, true}; };
  };
  const auto wire = [](Scene& scene) { scene.overlays.wireFrame = WireFrame{{0.1, 0, 0.3}, 1.7, 0.8, {}}; };
  return {{"OutlineAndSurface",
           [=](Scene& scene) {
             outline(scene);
             surface(0.3)(scene);
           }},
          {"WireFrame", wire},
          {"OpaqueSurface", surface(1)},
          {"AllWithIsosurface",
           [=](Scene& scene) {
             outline(scene);
             surface(0.25)(scene);
             wire(scene);
           }},
          {"IsosurfaceAloneInAWireFrame",
           [=](Scene& scene) {
             scene.mode = "isosurfaces";
             wire(scene);
           }},
          {"LitAndClippedWithFeatureEdges", [=](Scene& scene) {
             scene.lighting.emplace();
             scene.lighting->ambient = 0.4;
             surface(0.2)(scene);
             wire(scene);
             scene.overlays.wireFrame->featureAngle = 25;
           }}};
}

INSTANTIATE_TEST_SUITE_P(Meshes, OverlaysAgainstReference,
                         testing::Combine(testing::ValuesIn(someMeshes()), testing::ValuesIn(settings())),
                         [](const auto& test) {
                           return std::get<0>(test.param).name + "_" + std::get<1>(test.param).name;
                         });

}  // namespace
}  // namespace havs::test
