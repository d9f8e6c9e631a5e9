// `--k auto` against drawing with every k.
#include "render/k_search.h"

#include <gtest/gtest.h>

#include "gl/drawing.h"
#include "render/changes_k.h"
#include "support/gl_test.h"

namespace havs::test {
namespace {

class KSearch : public FramebufferFetch {
 protected:
  Scene sceneOf(const std::string& sort) {
    Scene scene;
    scene.width = scene.height = 96;
    scene.lookup = "post";
    scene.sort = sort;
    scene.certificate = true;
    return scene;
  }

  /// The first k from 1 to 14 without a misordered fragment; 14 where there is none.
  int smallestByTrying(Scene scene, const TetMesh& mesh) {
    for (scene.k = 1; scene.k < 14; ++scene.k)
      if (draw(*device_, scene, mesh).certificate->misordered == 0) break;
    return scene.k;
  }

  int searched(const Scene& scene, const TetMesh& mesh) {
    StageTimes stages;
    const PreparedScene prepared = prepareScene(scene, mesh, stages);
    const View view = makeView(scene.camera, prepared.frame, scene.width, scene.height);
    return searchK(scene, prepared, view, capabilitiesOf(*device_));
  }
};

TetMesh withSmoothField(TetMesh mesh) {
  auto values = smoothField(mesh.points);
  return withPointField(std::move(mesh), std::move(values));
}

TEST_P(KSearch, FindsTheSmallest) {
  const std::vector<TetMesh> meshes{withSmoothField(box(4, Cut::six, 0.25)), withSmoothField(twoBoxes(3, 0.1)),
                                    withSmoothField(stretchedLayers(5, 1.3)), withSmoothField(singleTetrahedron())};
  std::vector<int> found;
  for (const TetMesh& mesh : meshes)
    for (const char* sort : {"centroid", "topological"}) {
      found.push_back(searched(sceneOf(sort), mesh));
      EXPECT_EQ(found.back(), smallestByTrying(sceneOf(sort), mesh)) << sort << ", mesh of " << mesh.points.size();
    }
  EXPECT_GT(*std::max_element(found.begin(), found.end()), *std::min_element(found.begin(), found.end()));
}

TEST_P(KSearch, FindsTheSmallestWithEarlyTermination) {
  const TransferFile transfer(constantTransfer(3));
  Scene scene = sceneOf("centroid");
  scene.transferFunction = transfer.path();
  const TetMesh mesh = withSmoothField(box(4, Cut::six, 0.25));
  for (double opacity : {0.3, 0.9}) {
    scene.earlyTermination = opacity;
    EXPECT_EQ(searched(scene, mesh), smallestByTrying(scene, mesh)) << opacity;
  }
}

TEST_P(KSearch, BuildsTheTableOnceForAllItsTries) {
  Scene scene = sceneOf("none");
  scene.transferFunction = "viridis";
  scene.lookup = "3d";
  scene.tableSize = 8;
  scene.earlyTermination = 0.999;  // each k is tried, with the scene's own lookup
  StageTimes stages;
  const PreparedScene prepared = prepareScene(scene, withSmoothField(box(5, Cut::six, 0.25)), stages);
  const View view = makeView(scene.camera, prepared.frame, scene.width, scene.height);
  int tables = 0, tries = 0;
  const Progress progress = [&](std::string_view step, double done) {
    tables += step == "table" && done == 1.0;
    tries += step == "searching k" && done < 1.0;
  };
  Capabilities capabilities = capabilitiesOf(*device_);
  capabilities.maximumDrawBuffers = 3;
  EXPECT_EQ(searchK(scene, prepared, view, capabilities, progress), 4);
  EXPECT_EQ(tables, 1);
  EXPECT_EQ(tries, 3);
}

/// What is kept from one k to the next changes nothing.
TEST_P(KSearch, DrawsTheSameAfterAChangeOfK) {
  Scene scene = sceneOf("centroid");
  scene.transferFunction = "viridis";
  scene.lookup = Scene{}.lookup;
  StageTimes stages;
  const PreparedScene prepared = prepareScene(scene, withSmoothField(box(4, Cut::six, 0.25)), stages);
  const View view = makeView(scene.camera, prepared.frame, scene.width, scene.height);
  const auto planFor = [&](int k) {
    scene.k = k;
    return plan(scene, prepared.facts(), capabilitiesOf(*device_));
  };
  const auto renderer = makeRenderer(prepared, planFor(3), stages);
  for (const int k : {1, 6, 3}) {
    dynamic_cast<ChangesK&>(*renderer).changeK(planFor(k));
    const havs::Drawing changed = renderer->draw(view, stages);
    const havs::Drawing fresh = makeRenderer(prepared, planFor(k), stages)->draw(view, stages);
    EXPECT_EQ(changed.image.rgba, fresh.image.rgba) << k;
    EXPECT_EQ(changed.certificate->count, fresh.certificate->count) << k;
  }
}

TEST_P(KSearch, GivesTheLargestWhereNoneIsEnough) {
  const Scene scene = sceneOf("none");
  const TetMesh mesh = withSmoothField(box(5, Cut::six, 0.25));
  EXPECT_EQ(searched(scene, mesh), 14);
  Scene most = scene;
  most.k = 14;
  EXPECT_GT(draw(*device_, most, mesh).certificate->misordered, 0u);
}

TEST_P(KSearch, KeepsToTheTargetsOfTheMachine) {
  const Scene scene = sceneOf("none");
  StageTimes stages;
  const PreparedScene prepared = prepareScene(scene, withSmoothField(box(5, Cut::six, 0.25)), stages);
  const View view = makeView(scene.camera, prepared.frame, scene.width, scene.height);
  Capabilities capabilities = capabilitiesOf(*device_);
  capabilities.maximumDrawBuffers = 4;
  EXPECT_EQ(searchK(scene, prepared, view, capabilities), 6);
}

HAVS_FOR_EVERY_DEVICE(KSearch);

}  // namespace
}  // namespace havs::test
