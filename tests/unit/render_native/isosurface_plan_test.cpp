// What a plan holds for isosurfaces, and that it holds nothing for scenes without.
#include <gmock/gmock.h>

#include <limits>

#include "core/error.h"
#include "render/effects.h"
#include "scene/prepared_scene.h"
#include "support/meshes.h"

namespace havs::test {
namespace {

using testing::Contains;
using testing::HasSubstr;

struct Planned {
  RenderPlan plan;
  bool has(PlanKind kind) const {
    return std::any_of(plan.items.begin(), plan.items.end(), [&](const PlanItem& item) { return item.kind == kind; });
  }
  std::vector<std::string> resources() const {
    std::vector<std::string> names;
    for (const LookupResource& resource : plan.resources) names.push_back(resource.name);
    return names;
  }
  std::vector<std::string> defines() const {
    std::vector<std::string> names;
    for (const ShaderDefine& define : plan.defines) names.push_back(define.name);
    return names;
  }
};

class IsosurfacePlan : public testing::TestWithParam<bool> {
 protected:
  Planned planned(const Scene& scene) const {
    TetMesh mesh = ball(6);
    mesh.pointFields.push_back({"s", 1, linearField(mesh.points, {0.5, 0, 0})});
    StageTimes stages;
    const PreparedScene prepared = prepareScene(scene, std::move(mesh), stages);
    Capabilities capabilities;
    capabilities.native = GetParam();
    capabilities.hasExtension = [](const std::string&) { return true; };
    return {plan(scene, prepared.facts(), capabilities)};
  }
};

TEST_P(IsosurfacePlan, OfASceneWithoutHasNothingOfThem) {
  const Planned none = planned({});
  EXPECT_FALSE(none.plan.isosurfaces);
  EXPECT_THAT(none.resources(), testing::Not(Contains("isosurfaces")));
  EXPECT_THAT(none.defines(), testing::Not(Contains("HAVS_ISOSURFACES")));
  for (const PlanItem& item : none.plan.items)
    EXPECT_THAT(item.name + item.reason, testing::Not(HasSubstr("isosurface")));
}

TEST_P(IsosurfacePlan, OfASceneWithThemSaysWhy) {
  Scene scene;
  scene.isosurfaces = {{0.4, {}, 0.5}, {0.6, {}, 0.5}};
  const Planned with = planned(scene);
  EXPECT_TRUE(with.plan.isosurfaces);
  EXPECT_FALSE(with.plan.marksDonePixels);
  EXPECT_THAT(with.resources(), Contains("isosurfaces"));
  EXPECT_THAT(with.defines(), Contains("HAVS_ISOSURFACES"));
  const auto item = std::find_if(with.plan.items.begin(), with.plan.items.end(),
                                 [](const PlanItem& i) { return i.name.find("isosurfaces") != std::string::npos; });
  ASSERT_NE(item, with.plan.items.end());
  EXPECT_THAT(item->reason, HasSubstr("2 isosurfaces"));
}

// No table, no curve; the cells that they cross; on OpenGL, pixels behind an opaque one are spared.
TEST_P(IsosurfacePlan, AloneBuildsNothingOfTheVolume) {
  Scene scene;
  scene.mode = "isosurfaces";
  scene.lookup = "3d";
  scene.isosurfaces = {{0.4, {}, 1}};
  const Planned alone = planned(scene);
  EXPECT_THAT(alone.resources(), testing::ElementsAre("isosurfaces"));
  EXPECT_EQ(alone.plan.lookup.shader, "measure/nothing.glsl");
  EXPECT_EQ(alone.plan.tableSize, 0);
  EXPECT_FALSE(alone.plan.opaqueSurfaces);
  EXPECT_TRUE(alone.plan.leavesOutCells);
  EXPECT_FALSE(alone.plan.shows.volume);
  EXPECT_EQ(alone.plan.marksDonePixels, !GetParam());
}

INSTANTIATE_TEST_SUITE_P(Devices, IsosurfacePlan, testing::Bool(),
                         [](const auto& test) { return test.param ? "Native" : "OpenGl"; });

void expectRefused(const Scene& scene, const std::string& why) {
  try {
    checkScene(scene);
    ADD_FAILURE() << "not refused: " << why;
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::input);
    EXPECT_THAT(error.what(), HasSubstr(why));
  }
}

TEST(IsosurfaceScene, RefusesWhatCannotShowThem) {
  Scene scene;
  scene.mode = "isosurfaces";
  expectRefused(scene, "--isosurface");
  scene.isosurfaces = {{0.5, {}, 1}};
  scene.lookup = "pre";
  EXPECT_NO_THROW(checkScene(scene)) << "the mode has no need of the lookup";
  scene.mode = "volume";
  expectRefused(scene, "'pre'");
  scene.lookup = "exact";
  for (const Mode& row : modes()) {
    if (row.gathering == Gathering::composite) continue;
    scene.mode = row.name;
    expectRefused(scene, "no isosurface");
  }
  scene.mode = "volume";
  for (const double opacity : {0.0, -1.0, 1.01, std::numeric_limits<double>::quiet_NaN()}) {
    scene.isosurfaces = {{0.5, {}, opacity}};
    expectRefused(scene, "opacity");
  }
  scene.isosurfaces = {{std::numeric_limits<double>::infinity(), {}, 1}};
  expectRefused(scene, "no value");
  scene.isosurfaces = {{0.5, Color{0, 0, 1.5}, 1}};
  expectRefused(scene, "colour");
}

}  // namespace
}  // namespace havs::test
