// Lit scenes against the reference, which integrates colour times light by quadrature: every effect of light on both
// devices, with the lookup that lit scenes have by default.
#include <gtest/gtest.h>

#include <functional>
#include <optional>

#include "gl/device.h"
#include "image/compare.h"
#include "image/meshes_drawn.h"
#include "image/native_scene.h"
#include "reference/edge_mask.h"
#include "render/make_renderer.h"
#include "support/gl_test.h"
#include "support/meshes.h"

namespace havs::test {
namespace {

constexpr int kSize = 256;
/// Issue 5 promises an RMSE of 1e-3 and, on OpenGL, 5e-3 for all but a thousandth of the pixels. What is left out is
/// that colour times light bends between two knots of the transfer function in one cell: less than a product of two
/// differences within a cell; at a light's place, whose distance does not bend less near by, and where the gradient
/// turns within a cell, light is linear by definition.
constexpr double kNativeRmse = 1e-5, kNativeMaximum = 2e-3;
constexpr double kGlP999 = 5e-3;

struct Effect {
  std::string name;
  std::function<void(Scene&)> add;
};
inline void PrintTo(const Effect& effect, std::ostream* stream) { *stream << effect.name; }

std::vector<Effect> effectsOfLight() {
  const auto directional = [](Scene& scene) { scene.lights = {{SceneLight::Kind::directional, {1, 1, 1}, 1.0}}; };
  return {{"Head", [](Scene& scene) { scene.lighting.emplace(); }},
          {"Directional",
           [=](Scene& scene) {
             scene.lighting = Lighting{.ambient = 0.1, .diffuse = 0.7, .specular = 0.6, .shininess = 30};
             directional(scene);
           }},
          {"SeveralLights",
           [](Scene& scene) {
             scene.lighting.emplace();
             scene.lights = {{SceneLight::Kind::point, {3, 2, 4}, 0.5},
                             {SceneLight::Kind::directional, {0, 1, 0}, 0.4},
                             {SceneLight::Kind::head, {0, 0, 0}, 0.3}};
           }},
          {"Silhouettes", [](Scene& scene) { scene.lighting = Lighting{.silhouettes = 1}; }},
          {"Modulation", [](Scene& scene) { scene.modulation = 0.9; }},
          {"OcclusionAndShadows",
           [=](Scene& scene) {
             scene.occlusion = AmbientOcclusion{.radius = 0.2, .directions = 16};
             scene.shadows = true;
             directional(scene);
           }},
          {"All", [=](Scene& scene) {
             scene.lighting = Lighting{.silhouettes = 0.5};
             scene.occlusion = AmbientOcclusion{.directions = 16};
             scene.modulation = 0.5;
             scene.shadows = true;
             directional(scene);
           }}};
}

class LightAgainstReference : public testing::TestWithParam<std::tuple<MeshDrawn, Effect>> {
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
    scene.lookup = kAutoLookup;
    scene.width = scene.height = kSize;
    std::get<1>(GetParam()).add(scene);
    return scene;
  }

  void expectRight(const Scene& scene, const TetMesh& mesh) {
    const NativeScene drawn(scene, mesh);
    const Image truth = drawn.truth();
    const Comparison native = compareImages(drawn.draw().image, truth);
    EXPECT_LE(native.rgba.rmse, kNativeRmse);
    EXPECT_LE(native.rgba.max, kNativeMaximum) << "at " << native.worstX << ',' << native.worstY;

    StageTimes stages;
    const RenderPlan chosen = plan(scene, drawn.prepared.facts(), capabilitiesOf(*device_));
    const Image picture = makeRenderer(drawn.prepared, chosen, stages)->draw(drawn.view, stages).image;
    const auto mask = boundaryEdgeMask(drawn.prepared.points, drawn.prepared.faces, drawn.view);
    const Comparison gl = compareImages(picture, truth, mask);
    EXPECT_LE(gl.rgba.p999, kGlP999) << "at " << gl.worstX << ',' << gl.worstY;
    RecordProperty("native_rmse", std::to_string(native.rgba.rmse * 1e6) + "e-6");
    RecordProperty("native_max", std::to_string(native.rgba.max * 1e6) + "e-6");
    RecordProperty("gl_p999", std::to_string(gl.rgba.p999 * 1e6) + "e-6");
  }

  TetMesh mesh_;
  std::unique_ptr<Device> device_;
};

TEST_P(LightAgainstReference, ThreePeaks) { expectRight(sceneWith("three-peaks"), mesh_); }

TEST_P(LightAgainstReference, OpaqueSurfacesOrthographic) {
  Scene scene = sceneWith("plateau-opaque");
  scene.camera.projection = Projection::orthographic;
  scene.camera.azimuth = 200;
  scene.camera.elevation = -35;
  expectRight(scene, mesh_);
}

TEST_P(LightAgainstReference, CellData) {
  if (const auto& name = std::get<1>(GetParam()).name; name != "Head" && name != "All") return;  // nothing else in them
  expectRight(sceneWith("viridis"), withSmoothCells(mesh_));
}

std::vector<MeshDrawn> someMeshes() {
  std::vector<MeshDrawn> some;
  for (const MeshDrawn& mesh : meshesDrawn())
    if (mesh.name == "Spx" || mesh.name == "BluntFin" || mesh.name == "TetgenCube") some.push_back(mesh);
  return some;
}

/// Apart, as its table takes seconds, three times a picture.
std::vector<Effect> scattering() {
  return {{"Scattering", [](Scene& scene) {
             scene.scattering = AmbientScattering{.albedo = 0.8, .anisotropy = 0.3};
             scene.lights = {{SceneLight::Kind::directional, {1, 1, 1}, 1.0}};
           }}};
}
std::vector<MeshDrawn> oneMesh() { return {meshesDrawn().at(1)}; }

INSTANTIATE_TEST_SUITE_P(OneMesh, LightAgainstReference,
                         testing::Combine(testing::ValuesIn(oneMesh()), testing::ValuesIn(scattering())),
                         [](const auto& test) {
                           return std::get<0>(test.param).name + "_" + std::get<1>(test.param).name;
                         });

INSTANTIATE_TEST_SUITE_P(Meshes, LightAgainstReference,
                         testing::Combine(testing::ValuesIn(someMeshes()), testing::ValuesIn(effectsOfLight())),
                         [](const auto& test) {
                           return std::get<0>(test.param).name + "_" + std::get<1>(test.param).name;
                         });

}  // namespace
}  // namespace havs::test
