// --max-error: on three meshes the error asked for holds, and asking for less never costs less.
#include "study/choose_settings.h"

#include <gmock/gmock.h>

#include <array>
#include <cmath>
#include <limits>
#include <set>

#include "core/error.h"
#include "gl/drawing.h"
#include "render/render_scene.h"
#include "study/axes.h"
#include "support/gl_test.h"
#include "support/meshes.h"

namespace havs {
namespace {

struct NamedMesh {
  std::string name;
  TetMesh (*make)();
};

void PrintTo(const NamedMesh& mesh, std::ostream* stream) { *stream << mesh.name; }

Scene smallScene() {
  Scene scene;
  scene.transferFunction = "three-peaks";
  scene.width = 240;
  scene.height = 200;
  return scene;
}

PreparedScene prepared(TetMesh mesh) {
  StageTimes stages;
  mesh.pointFields = {Field{"s", 1, test::smoothField(mesh.points)}};
  return prepareScene(smallScene(), std::move(mesh), stages);
}

class ChooseSettings : public testing::TestWithParam<NamedMesh> {
 protected:
  static void SetUpTestSuite() { makeTestDevice("osmesa"); }  // its driver stays loaded
};

double costOf(const ChosenSettings& chosen, const PreparedScene& mesh) {
  for (const Candidate& one : candidatesFor(smallScene(), {countFragments(smallScene(), mesh)}))
    if (settingsKey(one.scene) == settingsKey(chosen.scene)) return one.cost;
  ADD_FAILURE() << "not a candidate: " << settingsLabel(chosen.scene);
  return 0;
}

TEST_P(ChooseSettings, KeepsWhatWasAskedAndNeverPaysLessForLess) {
  constexpr std::array kAsked{0.03, 0.003, 0.0003};
  const PreparedScene mesh = prepared(GetParam().make());
  std::vector<ChosenSettings> all;
  {
    SettingsChooser chooser(smallScene(), mesh, "p999");
    for (const double asked : kAsked) all.push_back(chooser.choose(asked));
    try {
      chooser.choose(1e-9);
      ADD_FAILURE() << "float pictures are not that exact";
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::running);
      EXPECT_THAT(error.what(), testing::HasSubstr("the best reached"));
      EXPECT_THAT(error.what(), testing::HasSubstr("exact"));
    }
  }
  for (std::size_t i = 0; i < all.size(); ++i) {
    const ChosenSettings& chosen = all[i];
    EXPECT_LE(chosen.estimate, kErrorMargin * kAsked[i]);
    EXPECT_EQ(chosen.probeWidth, 160);
    EXPECT_EQ(chosen.probeHeight, 133);
    EXPECT_EQ(chosen.scene.width, 240);
    const RenderReport report = renderScene(chosen.scene, mesh, {});
    EXPECT_LE(trueError(chosen.scene, mesh, report.image, {kAsked[i]}), kAsked[i]) << settingsLabel(chosen.scene);
    if (i > 0) {
      EXPECT_GE(costOf(chosen, mesh), costOf(all[i - 1], mesh)) << settingsLabel(chosen.scene);
    }
  }
}

const std::vector<NamedMesh> kMeshes{
    {"Ball", [] { return test::ball(5); }},
    {"JitteredBox", [] { return test::box(4, test::Cut::five, 0.2); }},
    {"NestedShells", [] { return test::nestedShells(5); }},
};
INSTANTIATE_TEST_SUITE_P(Meshes, ChooseSettings, testing::ValuesIn(kMeshes),
                         [](const auto& one) { return one.param.name; });

TEST(Candidates, StandInTheOrderOfTheirCostEachOnce) {
  const std::vector<Candidate> all = candidatesFor(smallScene(), {1e6});
  ASSERT_GT(all.size(), 20u);
  std::set<std::string> keys;
  for (std::size_t i = 0; i < all.size(); ++i) {
    EXPECT_TRUE(keys.insert(settingsKey(all[i].scene)).second) << settingsLabel(all[i].scene);
    if (i > 0) {
      EXPECT_GE(all[i].cost, all[i - 1].cost);
    }
  }
}

/// Over many frames a table pays for itself; for one it may not.
TEST(Candidates, CountATableOnceAndAFrameAsOftenAsItIsDrawn) {
  const auto has128 = [](int repeat) {
    Scene scene = smallScene();
    scene.repeat = repeat;
    const auto all = candidatesFor(scene, {1e6});
    return std::any_of(all.begin(), all.end(),
                       [](const Candidate& one) { return one.scene.lookup == "3d" && one.scene.tableSize == 128; });
  };
  EXPECT_FALSE(has128(1));
  EXPECT_TRUE(has128(20));
}

/// Where cells hold few knots, hardly anything is cheaper than `exact`; where they hold many, tables are.
TEST(Candidates, OnTheNativeDeviceExactIsAsDearAsTheKnotsInCells) {
  Scene scene = smallScene();
  scene.device = "native";
  const auto hasNormalised = [&](double knotsInCells) {
    const auto all = candidatesFor(scene, {1e6, knotsInCells});
    return std::any_of(all.begin(), all.end(),
                       [](const Candidate& one) { return one.scene.lookup == "3d-normalised"; });
  };
  EXPECT_FALSE(hasNormalised(0.1));
  EXPECT_TRUE(hasNormalised(70));
}

/// Faces that lie one behind the other count each: the a-buffer counts the fragments themselves.
TEST(CountFragments, ComesNearToWhatIsDrawn) {
  makeTestDevice("osmesa");
  const PreparedScene mesh = prepared(test::ball(5));
  Scene scene = smallScene();
  scene.visibility = "abuffer";
  const auto drawn = static_cast<double>(renderScene(scene, mesh, {}).fragments);
  EXPECT_NEAR(countFragments(scene, mesh), drawn, 0.02 * drawn);  // pixels at the rim of faces
}

TEST(CheckGoal, RefusesWhatIsNoBound) {
  for (const double most : {0.0, -1.0, std::nan(""), std::numeric_limits<double>::infinity()})
    EXPECT_THROW(checkGoal({most}), Error) << most;
  EXPECT_THROW(checkGoal({0.1, "mean"}), Error);
  for (const ErrorMeasure& row : errorMeasures()) EXPECT_NO_THROW(checkGoal({0.1, row.name}));
}

}  // namespace
}  // namespace havs
