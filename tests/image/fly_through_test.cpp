// Flights through meshes: cameras outside, in cells, in hollows, and from one to the other, against the reference,
// which needs no cut for an eye in a cell.
#include <gtest/gtest.h>

#include "image/compare.h"
#include "image/meshes_drawn.h"
#include "mesh/read.h"
#include "mesh/scalar_field.h"
#include "reference/edge_mask.h"
#include "reference/reference_renderer.h"
#include "render/devices.h"
#include "render/make_renderer.h"
#include "scene/eye_cut.h"
#include "support/fly_path.h"
#include "support/gl_test.h"

namespace havs::test {
namespace {

constexpr int kFrames = 12;

/// Blunt fin, and a TetGen mesh with three tunnels.
std::vector<MeshDrawn> meshesToFlyThrough() {
  std::vector<MeshDrawn> meshes;
  for (const MeshDrawn& mesh : meshesDrawn())
    if (mesh.name == "BluntFin") meshes.push_back(mesh);
  meshes.push_back({"TetgenBracket", 96, []() -> std::optional<TetMesh> {
                      if (!HAVS_WITH_TETGEN) return std::nullopt;
                      TetMesh mesh = readMesh(HAVS_MESHES "/bracket.poly", {.tetgenSwitches = "pq1.4a0.005"});
                      mesh.pointFields = {fieldFromExpression(mesh, "s", "sin(3*x)*cos(2*y)+z")};
                      return mesh;
                    }});
  return meshes;
}

class FlyThrough : public testing::TestWithParam<MeshDrawn> {
 protected:
  void SetUp() override {
    auto mesh = GetParam().make();
    if (!mesh)
      GTEST_SKIP() << "no such mesh here: TetGen is left out of the build, or there is no " << HAVS_SHARED_DATA;
    scene_.width = scene_.height = 96;
    scene_.lookup = "exact";
    StageTimes stages;
    prepared_ = prepareScene(scene_, std::move(*mesh), stages);
  }

  /// check(picture, truth, mask, cameras' view) of every frame by one renderer; how many frames have the eye in a cell.
  template <class Check>
  int fly(const Capabilities& capabilities, const Check& check) {
    StageTimes stages;
    const auto renderer = makeRenderer(prepared_, plan(scene_, prepared_.facts(), capabilities), stages);
    const auto reference = makeReferenceRenderer(prepared_);
    int inside = 0;
    for (const Camera& camera : flyPath(prepared_, kFrames)) {
      scene_.camera = camera;
      const View view = viewOf(scene_, prepared_);
      const Image truth = reference->draw(view, stages).image;
      check(renderer->draw(view, stages).image, truth, boundaryEdgeMask(prepared_.points, prepared_.faces, view), view);
      inside += reachesMesh(prepared_, view.eye) ? 1 : 0;
    }
    return inside;
  }

  /// Of a ray's opacity, what may be missing for what is left out before the cut.
  double leftOut(const View& view, const EyeCut& cut) const {
    return prepared_.curve.maximumKappa * cut.distance * view.rayScale(0.5, 0.5);
  }

  Scene scene_;
  PreparedScene prepared_;
};

// 1e-5 is what the roundings of float leave without a cut (native_accuracy_test.cpp).
TEST_P(FlyThrough, NativeIsTheReferenceInEveryPixel) {
  const int inside = fly(openRenderDevice("native").capabilities,
                         [&](const Image& picture, const Image& truth, const auto&, const View& view) {
                           const ErrorMeasures error = compareImages(picture, truth).rgba;
                           EXPECT_LE(error.max, 1e-5 + leftOut(view, kEyeCutInDouble));
                           EXPECT_LE(error.rmse, 5e-6);
                         });
  EXPECT_GE(inside, 3);
  EXPECT_LE(inside, kFrames - 3);
}

// Outside the edge mask; 1e-4 is what OpenGL's float distances leave of most pictures (accuracy_test.cpp).
TEST_P(FlyThrough, OpenGlIsTheReferenceBesideEdges) {
  const auto device = makeTestDevice("osmesa");
  fly(capabilitiesOf(*device), [&](const Image& picture, const Image& truth, const auto& mask, const View& view) {
    EXPECT_LE(compareImages(picture, truth, mask).rgba.p999, 1e-4 + leftOut(view, kEyeCutInFloat));
  });
}

// The same frame again is drawn from the same cut, to the same bits; a frame from elsewhere between them changes
// nothing.
TEST_P(FlyThrough, FramesDoNotDependOnThoseBefore) {
  StageTimes stages;
  const auto renderer =
      makeRenderer(prepared_, plan(scene_, prepared_.facts(), openRenderDevice("native").capabilities), stages);
  const std::vector<Camera> cameras = flyPath(prepared_, kFrames);
  const auto frame = [&](std::size_t i) {
    scene_.camera = cameras[i];
    return renderer->draw(viewOf(scene_, prepared_), stages).image.rgba;
  };
  const auto middle = frame(kFrames / 2), first = frame(0);
  EXPECT_EQ(frame(0), first);
  EXPECT_EQ(frame(kFrames / 2), middle);
  EXPECT_EQ(frame(kFrames / 2), middle);
}

INSTANTIATE_TEST_SUITE_P(Meshes, FlyThrough, testing::ValuesIn(meshesToFlyThrough()),
                         [](const testing::TestParamInfo<MeshDrawn>& row) { return row.param.name; });

}  // namespace
}  // namespace havs::test
