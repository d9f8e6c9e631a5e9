// Every mode that needs no order against the reference: on the native device and on OpenGL, perspective and
// orthographic, point data and cell data.
#include "render/modes.h"

#include <gtest/gtest.h>

#include <optional>

#include "gl/device.h"
#include "gl/drawing.h"
#include "image/compare.h"
#include "image/meshes_drawn.h"
#include "image/native_scene.h"
#include "reference/edge_mask.h"
#include "render/make_renderer.h"
#include "support/gl_test.h"

namespace havs::test {
namespace {

constexpr int kSize = 256;
/// Native: sums of some hundred segments of float, each off by 2^-24 of what it adds (X-ray, emission); colours of one
/// scalar that is off by 2^-24, where the colour map goes from one end to the other in a hundredth of it (three-peaks).
constexpr double kNativeRmse = 1e-6, kNativeMaximum = 5e-5;
/// The mean over a ray that just touches a cell divides by a length of float's rounding; with cell data the cells there
/// differ by as much as they like. A few pixels a picture.
constexpr double kGrazingMaximum = 1e-3;
/// What issue 5 promises of OpenGL. Beyond the rasteriser's grid, which the mask covers at boundary edges only, float
/// places on faces seen edge on.
constexpr double kGlP999 = 5e-3;

std::vector<std::string> unorderedModes() {
  std::vector<std::string> names;
  for (const Mode& row : modes())
    if (row.gathering != Gathering::composite) names.push_back(row.name);
  return names;
}

class ModeAgainstReference : public testing::TestWithParam<std::tuple<MeshDrawn, std::string>> {
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
    scene.mode = std::get<1>(GetParam());
    scene.transferFunction = transfer;
    scene.width = scene.height = kSize;
    return scene;
  }

  void expectRight(const Scene& scene, const TetMesh& mesh) {
    const NativeScene drawn(scene, mesh);
    const Image truth = drawn.truth();
    const Comparison native = compareImages(drawn.draw().image, truth);
    EXPECT_LE(native.rgba.rmse, kNativeRmse);
    const bool grazing = scene.mode == "average" && drawn.prepared.facts().cellData;
    EXPECT_LE(native.rgba.max, grazing ? kGrazingMaximum : kNativeMaximum)
        << "at " << native.worstX << ',' << native.worstY;

    StageTimes stages;
    const RenderPlan chosen = plan(scene, drawn.prepared.facts(), capabilitiesOf(*device_));
    const Image picture = makeRenderer(drawn.prepared, chosen, stages)->draw(drawn.view, stages).image;
    const auto mask = boundaryEdgeMask(drawn.prepared.points, drawn.prepared.faces, drawn.view);
    const Comparison gl = compareImages(picture, truth, mask);
    EXPECT_LE(gl.rgba.p999, kGlP999) << "at " << gl.worstX << ',' << gl.worstY;
    RecordProperty("native_rmse", std::to_string(native.rgba.rmse));
    RecordProperty("native_max", std::to_string(native.rgba.max));
    RecordProperty("gl_p999", std::to_string(gl.rgba.p999));
  }

  TetMesh mesh_;
  std::unique_ptr<Device> device_;
};

TEST_P(ModeAgainstReference, Perspective) { expectRight(sceneWith("viridis"), mesh_); }

TEST_P(ModeAgainstReference, Orthographic) {
  Scene scene = sceneWith("three-peaks");
  scene.camera.projection = Projection::orthographic;
  scene.camera.azimuth = 200;
  scene.camera.elevation = -35;
  expectRight(scene, mesh_);
}

/// What fits into registers (transfer/few_pieces.h): a step, a piece for every few cells, opacity per unit length.
TEST_P(ModeAgainstReference, TransferFunctionOfFewPieces) {
  const TransferFile transfer(R"({"version": 1, "opacity": "extinction", "unit_length": 0.5, "points": [
      {"scalar": 0, "color": [0.1, 0, 0.3], "opacity": 0.1}, {"scalar": 0.3, "color": [0.2, 0.5, 0.6], "opacity": 1.5},
      {"scalar": 0.55, "color": [0.1, 0.6, 0.5], "opacity": 0.2}, {"scalar": 0.55, "color": [0.9, 0.8, 0.1], "opacity": 2},
      {"scalar": 1, "color": [1, 0.3, 0.1], "opacity": 0.3}]})");
  expectRight(sceneWith(transfer.path()), mesh_);
}

TEST_P(ModeAgainstReference, CellData) { expectRight(sceneWith("viridis"), withSmoothCells(mesh_)); }

std::vector<MeshDrawn> someMeshes() {
  std::vector<MeshDrawn> some;
  for (const MeshDrawn& mesh : meshesDrawn())
    if (mesh.name == "Spx" || mesh.name == "BluntFin" || mesh.name == "TetgenTorusKnot" || mesh.name == "BoxWithHole")
      some.push_back(mesh);
  return some;
}

INSTANTIATE_TEST_SUITE_P(Meshes, ModeAgainstReference,
                         testing::Combine(testing::ValuesIn(someMeshes()), testing::ValuesIn(unorderedModes())),
                         [](const auto& test) { return std::get<0>(test.param).name + "_" + std::get<1>(test.param); });

}  // namespace
}  // namespace havs::test
