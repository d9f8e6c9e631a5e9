// Every row of effects() against the reference, on both devices: alone, in perspective and orthographic; each pair; and
// each from within the mesh. The rows themselves say how a scene asks for them, so that a new one is drawn here, too.
#include "render/effects.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "gl/device.h"
#include "image/compare.h"
#include "image/meshes_drawn.h"
#include "image/native_scene.h"
#include "reference/edge_mask.h"
#include "render/make_renderer.h"
#include "scene/eye_cut.h"
#include "support/effect_subsets.h"
#include "support/gl_test.h"

namespace havs::test {
namespace {

/// As without effects (native_accuracy_test.cpp).
constexpr double kNativeRmse = 1e-6, kNativeMaximum = 1e-5;
/// Where light falls, colour times light bends between two knots of the transfer function in one cell (light_test.cpp),
/// by a product of two differences within the cell: of a box of 6 x 6 x 6 cells these are large.
constexpr double kLitRmse = 5e-4, kLitMaximum = 2e-3;  // from within, the cells about the eye fill the picture
/// Of the pixels, those whose order is wrong by the certificate: rays along the jagged rim of what a threshold leaves.
constexpr double kMostMisordered = 1e-4;
/// What issue 5 promises of OpenGL.
constexpr double kGlP999 = 5e-3;

class EffectsTest : public testing::Test {
 protected:
  void SetUp() override { device_ = makeTestDevice("osmesa"); }

  Scene plain(int size) const {
    Scene scene;
    scene.transferFunction = "viridis";
    scene.lookup = "exact";
    scene.width = scene.height = size;
    return scene;
  }
  static EffectData dataOf(const Scene& scene, const TetMesh& mesh) {
    StageTimes stages;
    const PreparedScene prepared = prepareScene(scene, mesh, stages);
    return {prepared.curve.domain, prepared.frame.center};
  }

  static std::vector<unsigned char> misorderedIn(const havs::Drawing& drawing) {
    std::vector<unsigned char> mask(drawing.image.rgba.size() / 4, 0);
    if (!drawing.certificate) return mask;
    EXPECT_LE(static_cast<double>(drawing.certificate->pixels), kMostMisordered * static_cast<double>(mask.size()));
    for (std::size_t i = 0; i < mask.size(); ++i) mask[i] = drawing.certificate->count[i] > 0 ? 1 : 0;
    return mask;
  }

  /// Light is linear between the faces that a ray meets; where the eye's plane cuts cells these are more, so that lit
  /// pictures from within are held against the reference of the mesh as it was cut.
  static Image truthOf(const NativeScene& drawn, const EyeCut& how) {
    if (!lightPlanOf(drawn.scene).lit || !needsEyeCut(drawn.prepared, drawn.view, how)) return drawn.truth();
    const PreparedScene cut = cutBeforeEye(drawn.prepared, drawn.view, how);
    StageTimes stages;
    return makeReference(drawn.scene, cut)->draw(viewOfCut(cut, drawn.view), stages, {}).image;
  }

  void expectRight(const Scene& scene, const TetMesh& mesh) {
    const bool lit = lightPlanOf(scene).lit;
    Scene counted = scene;
    counted.certificate = true;
    const NativeScene drawn(counted, mesh);
    const Image truth = truthOf(drawn, kEyeCutInDouble);
    ASSERT_TRUE(std::any_of(truth.rgba.begin(), truth.rgba.end(), [](float number) { return number > 0; }));
    const havs::Drawing picture = drawn.draw();
    const auto misordered = misorderedIn(picture);
    const Comparison native = compareImages(picture.image, truth, misordered);
    EXPECT_LE(native.rgba.rmse, lit ? kLitRmse : kNativeRmse);
    EXPECT_LE(native.rgba.max, lit ? kLitMaximum : kNativeMaximum) << "at " << native.worstX << ',' << native.worstY;
    worstRmse_ = std::max(worstRmse_, native.rgba.rmse);
    worst_ = std::max(worst_, native.rgba.max);

    StageTimes stages;
    const RenderPlan chosen = plan(counted, drawn.prepared.facts(), capabilitiesOf(*device_));
    const havs::Drawing second = makeRenderer(drawn.prepared, chosen, stages)->draw(drawn.view, stages, {});
    auto mask = boundaryEdgeMask(drawn.prepared.points, drawn.prepared.faces, drawn.view);
    const auto late = misorderedIn(second);
    for (std::size_t i = 0; i < mask.size(); ++i) mask[i] |= late[i];
    const bool cut = needsEyeCut(drawn.prepared, drawn.view, kEyeCutInFloat);
    const Comparison gl = compareImages(second.image, lit && cut ? truthOf(drawn, kEyeCutInFloat) : truth, mask);
    EXPECT_LE(gl.rgba.p999, kGlP999) << "at " << gl.worstX << ',' << gl.worstY;
    worstGl_ = std::max(worstGl_, gl.rgba.p999);
  }
  void TearDown() override {
    RecordProperty("native_rmse", std::to_string(worstRmse_ * 1e6) + "e-6");
    RecordProperty("native_max", std::to_string(worst_ * 1e6) + "e-6");
    RecordProperty("gl_p999", std::to_string(worstGl_ * 1e6) + "e-6");
  }

  std::unique_ptr<Device> device_;
  double worstRmse_ = 0, worst_ = 0, worstGl_ = 0;
};

std::string asTestName(std::string name) {
  std::replace_if(
      name.begin(), name.end(), [](unsigned char c) { return std::isalnum(c) == 0; }, '_');
  return name;
}
std::vector<const Effect*> rows() {
  std::vector<const Effect*> all;
  for (const Effect& row : effects()) all.push_back(&row);
  return all;
}

class EachEffect : public EffectsTest, public testing::WithParamInterface<std::tuple<MeshDrawn, const Effect*>> {};

TEST_P(EachEffect, IsAsInTheReference) {
  const auto& [drawn, effect] = GetParam();
  const auto mesh = drawn.make();
  if (!mesh) GTEST_SKIP() << "no such mesh here: TetGen is left out of the build, or there is no " << HAVS_SHARED_DATA;
  Scene scene = plain(256);
  ask(scene, *effect, dataOf(scene, *mesh));
  expectRight(scene, *mesh);
  scene.camera.projection = Projection::orthographic;
  scene.camera.azimuth = 200;
  scene.camera.elevation = -35;
  expectRight(scene, *mesh);
}

std::vector<MeshDrawn> meshesWith(const std::vector<std::string>& names) {
  std::vector<MeshDrawn> some;
  for (const MeshDrawn& mesh : meshesDrawn())
    if (std::find(names.begin(), names.end(), mesh.name) != names.end()) some.push_back(mesh);
  return some;
}

INSTANTIATE_TEST_SUITE_P(Meshes, EachEffect,
                         testing::Combine(testing::ValuesIn(meshesWith({"Spx", "BluntFin", "TetgenCube"})),
                                          testing::ValuesIn(rows())),
                         [](const auto& test) {
                           return std::get<0>(test.param).name + "_" + asTestName(std::get<1>(test.param)->name);
                         });

class EffectPairs : public EffectsTest, public testing::WithParamInterface<const Effect*> {
 protected:
  /// With every later row, so that each pair is drawn once.
  void expectPairsRight(const std::string& meshName, const Camera& camera) {
    const TetMesh mesh = *meshesWith({meshName}).at(0).make();
    Scene base = plain(128);
    base.camera = camera;
    const EffectData data = dataOf(base, mesh);
    for (const Effect* other = GetParam(); other != effects().data() + effects().size(); ++other) {
      SCOPED_TRACE(other->name);
      Scene scene = base;
      ask(scene, *GetParam(), data);
      ask(scene, *other, data);
      // The cut mesh has other boundaries and another box than the mesh whose shape is drawn.
      if (camera.eye && lightPlanOf(scene).lit && scene.overlays.any()) continue;
      expectRight(scene, mesh);
    }
  }
};

TEST_P(EffectPairs, AreAsInTheReference) {
  Camera camera;
  camera.azimuth = 40;
  camera.elevation = 25;
  expectPairsRight("JitteredBox", camera);
}

/// The eye lies on the side of the centre that the clip plane of the row keeps.
TEST_P(EffectPairs, FromWithinTheMesh) {
  Camera camera;
  camera.eye = Vec3(0.3, 0.4, 0.2);
  camera.target = Vec3(0.9, 0.1, 0.6);
  camera.fieldOfView = 80;
  expectPairsRight("JitteredBox", camera);
}

INSTANTIATE_TEST_SUITE_P(Rows, EffectPairs, testing::ValuesIn(rows()),
                         [](const auto& test) { return asTestName(test.param->name); });

}  // namespace
}  // namespace havs::test
