#include "study/axes.h"

#include <gmock/gmock.h>

#include <set>

#include "core/error.h"
#include "render/lookups.h"
#include "render/target_formats.h"
#include "render/visibility.h"
#include "sort/face_order.h"

namespace havs {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

class EveryAxis : public testing::TestWithParam<std::string> {};

/// So a table of results says what was drawn, and a value of the baseline is found again.
TEST_P(EveryAxis, TellsTheValueThatItApplied) {
  const StudyAxis& row = axis(GetParam());
  for (const bool quick : {false, true})
    for (const std::string& value : row.values(quick)) {
      Scene scene;
      row.apply(scene, value);
      EXPECT_EQ(row.valueOf(scene), value);
    }
}

TEST_P(EveryAxis, LeavesASceneAloneThatHasTheValueAlready) {
  const StudyAxis& row = axis(GetParam());
  Scene scene;
  scene.width = 301;
  scene.height = 77;
  const std::string before = settingsKey(scene);
  row.apply(scene, row.valueOf(scene));
  EXPECT_EQ(settingsKey(scene), before);
  EXPECT_EQ(scene.width, 301);
  EXPECT_EQ(scene.height, 77);
}

/// What a value changes, two scenes must be told apart by, or one of them would not be drawn.
TEST_P(EveryAxis, TellsItsValuesApart) {
  const StudyAxis& row = axis(GetParam());
  std::set<std::string> keys;
  for (const std::string& value : row.values(false)) {
    Scene scene;
    row.apply(scene, value);
    if (!row.applies(scene)) continue;
    EXPECT_TRUE(keys.insert(settingsKey(scene)).second) << value;
  }
  EXPECT_FALSE(keys.empty());
}

TEST_P(EveryAxis, RefusesWhatIsNoValue) {
  const StudyAxis& row = axis(GetParam());
  Scene scene;
  EXPECT_THROW(row.apply(scene, "nonsense"), Error);
  EXPECT_THROW(row.apply(scene, ""), Error);
  EXPECT_THROW(chooseAxes(std::vector<std::string>{row.name + "=1,,2"}, false), Error);
}

std::vector<std::string> axisNames() {
  std::vector<std::string> names;
  for (const StudyAxis& row : axes()) names.push_back(row.name);
  return names;
}

INSTANTIATE_TEST_SUITE_P(Axes, EveryAxis, testing::ValuesIn(axisNames()), [](const auto& one) {
  std::string name = one.param;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
});

template <class Rows>
std::vector<std::string> namesOf(const Rows& rows) {
  std::vector<std::string> names;
  for (const auto& row : rows) names.push_back(row.name);
  return names;
}

/// Whatever others add to their tables is swept without a change here.
TEST(Axes, SweepTheRowsOfTheTablesOfMethods) {
  EXPECT_EQ(axis("visibility").values(false), namesOf(visibilityMethods()));
  EXPECT_EQ(axis("sort").values(false), namesOf(sortMethods()));
  EXPECT_EQ(axis("target-format").values(false), namesOf(targetFormats()));
  EXPECT_EQ(axis("table-format").values(false), namesOf(tableFormats()));
  for (const Lookup& row : lookups()) {
    const auto values = axis("lookup").values(false);
    EXPECT_TRUE(std::any_of(values.begin(), values.end(), [&](const std::string& value) {
      return lookup(value).shader == row.shader;
    })) << row.name;
  }
}

TEST(Axes, ApplyWhereTheirSettingHasAnEffect) {
  Scene scene;
  scene.lookup = "3d";
  EXPECT_TRUE(axis("table").applies(scene));
  EXPECT_TRUE(axis("table-format").applies(scene));
  scene.lookup = "post";
  EXPECT_FALSE(axis("table").applies(scene));
  EXPECT_FALSE(axis("table-format").applies(scene));
  for (const VisibilityMethod& method : visibilityMethods()) {
    scene.visibility = method.name;
    EXPECT_EQ(axis("k").applies(scene), method.maximumK > 0) << method.name;
    EXPECT_EQ(axis("sort").applies(scene), method.needsOrder) << method.name;
  }
}

TEST(Axes, KeepTheAspectOfAPicture) {
  Scene scene;
  scene.width = 640;
  scene.height = 480;
  axis("size").apply(scene, "320");
  EXPECT_EQ(scene.width, 320);
  EXPECT_EQ(scene.height, 240);
  scene.width = 10;
  scene.height = 1000;
  axis("size").apply(scene, "20");
  EXPECT_EQ(scene.width, 1);  // not 0
  EXPECT_EQ(scene.height, 20);
}

TEST(SettingsKey, LeavesOutWhatHasNoEffect) {
  Scene a, b;
  a.lookup = b.lookup = "post";
  b.tableSize = 16;
  b.tableFormat = "rgba8";
  EXPECT_EQ(settingsKey(a), settingsKey(b));
  b.k = a.k + 1;
  EXPECT_NE(settingsKey(a), settingsKey(b));
  b = a;
  b.compositeLate = !a.compositeLate;
  EXPECT_NE(settingsKey(a), settingsKey(b));
}

/// A size that is asked for is the same as the lookup's own where both are equal, and a lookup without it has its own.
TEST(SettingsKey, KnowsTheSizeOfATableThatWasNotAskedFor) {
  for (const Lookup& row : lookups()) {
    const LookupResource* table = tableOf(row);
    if (table == nullptr) continue;
    Scene own, asked;
    own.lookup = asked.lookup = row.name;
    asked.tableSize = table->ownSize;
    EXPECT_EQ(settingsKey(own), settingsKey(asked)) << row.name;
    asked.tableSize = table->ownSize + 1;
    EXPECT_NE(settingsKey(own), settingsKey(asked)) << row.name;
  }
}

TEST(SettingsLabel, NamesWhatHasAnEffect) {
  Scene scene;
  scene.k = 2;
  EXPECT_THAT(settingsLabel(scene), testing::StartsWith("kbuffer k 2, topological, 3d-normalised 64^3 rgba32f"));
  scene.lookup = "2d";
  scene.tableSize = 32;
  EXPECT_THAT(settingsLabel(scene), testing::StartsWith("kbuffer k 2, topological, 2d 32^2 rgba32f"));
  scene.lookup = "post";
  scene.earlyTermination = 0.99;
  EXPECT_THAT(settingsLabel(scene), testing::StartsWith("kbuffer k 2, topological, post"));
  EXPECT_THAT(settingsLabel(scene), HasSubstr("0.99"));
}

TEST(ChooseAxes, TakesAllRowsByDefault) {
  const auto choices = chooseAxes({}, false);
  ASSERT_EQ(choices.size(), axes().size());
  for (std::size_t i = 0; i < choices.size(); ++i) {
    EXPECT_EQ(choices[i].axis, &axes()[i]);
    EXPECT_EQ(choices[i].values, axes()[i].values(false));
  }
}

TEST(ChooseAxes, TakesValuesAsGivenEachOnce) {
  const std::vector<std::string> texts{"k=3,1,3,01", "sort", "early-termination=0.990,0.99"};
  const auto choices = chooseAxes(texts, false);
  ASSERT_EQ(choices.size(), 3u);
  EXPECT_THAT(choices[0].values, ElementsAre("3", "1"));
  EXPECT_EQ(choices[1].values, axis("sort").values(false));
  EXPECT_THAT(choices[2].values, ElementsAre("0.99"));
}

std::string refusalOf(const std::vector<std::string>& texts) {
  try {
    chooseAxes(texts, false);
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::input);
    return error.what();
  }
  return "";
}

TEST(ChooseAxes, RefusesWhatItDoesNotKnow) {
  EXPECT_THAT(refusalOf({"sorting=none"}), HasSubstr("did you mean 'sort'"));
  EXPECT_THAT(refusalOf({"sort=topologcal"}), HasSubstr("did you mean 'topological'"));
  EXPECT_THAT(refusalOf({"k=two"}), HasSubstr("'two' is not a whole number"));
  EXPECT_THAT(refusalOf({"k="}), HasSubstr("--axis k"));
  EXPECT_THAT(refusalOf({"k=1", "k=2"}), HasSubstr("given twice"));
}

}  // namespace
}  // namespace havs
