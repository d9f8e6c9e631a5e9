// Which effects a study adds and leaves out, and what it says they cost.
#include "study/effect_runs.h"

#include <gmock/gmock.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "study/study_report.h"

namespace havs {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using Json = nlohmann::json;

Scene litScene() {
  Scene scene;
  scene.lookup = "exact";
  scene.lighting.emplace();
  scene.shadows = true;
  return scene;
}

const PlannedRun* find(const SweepPlan& plan, const std::string& effect) {
  for (const PlannedRun& run : plan.runs)
    if (run.effect == effect) return &run;
  return nullptr;
}

TEST(EffectRuns, AddWhatTheSceneLacksAndLeaveOutWhatItHas) {
  const Scene baseline = litScene();
  const SweepPlan plan = planEffects("a-0", baseline, {});
  EXPECT_TRUE(plan.skipped.empty());
  ASSERT_EQ(plan.runs.size(), effects().size());
  std::set<std::string> ids;
  for (std::size_t i = 0; i < plan.runs.size(); ++i) {
    const PlannedRun& run = plan.runs[i];
    const Effect& effect = effects()[i];
    SCOPED_TRACE(effect.name);
    EXPECT_EQ(run.effect, effect.name);
    EXPECT_EQ(run.kind, RunKind::effect);
    EXPECT_EQ(run.adds, !effect.wanted(baseline));
    EXPECT_NE(effect.wanted(run.scene), effect.wanted(baseline));
    EXPECT_TRUE(ids.insert(run.id).second);
  }
}

TEST(EffectRuns, SayWhatComesAndGoesWithAnEffect) {
  const PlannedRun without = *find(planEffects("a-0", litScene(), {}), "lighting");
  EXPECT_THAT(without.also, ElementsAre("shadows"));
  EXPECT_EQ(effectLabel(without), "without lighting nor shadows");
  const PlannedRun with = *find(planEffects("a-0", {}, {}), "shadows");
  EXPECT_THAT(with.also, ElementsAre("lighting"));
  EXPECT_EQ(effectLabel(with), "with shadows and lighting");
}

TEST(EffectRuns, SkipWhatCannotBeDrawnAndSayWhy) {
  Scene scene;
  scene.mode = "xray";
  const SweepPlan plan = planEffects("a-0", scene, {});
  EXPECT_EQ(plan.runs.size() + plan.skipped.size(), effects().size());
  EXPECT_EQ(find(plan, "lighting"), nullptr);
  EXPECT_NE(find(plan, "clipping"), nullptr);
  EXPECT_THAT(plan.skipped,
              testing::Contains(testing::AllOf(HasSubstr("a-0/with lighting"), HasSubstr("knows no light"))));
}

TEST(EffectRuns, AreMadeForTheData) {
  const SweepPlan plan = planEffects("a-0", {}, {{100, 300}, Vec3(7, 8, 9)});
  EXPECT_EQ(find(plan, "isosurfaces")->scene.isosurfaces.at(0).value, 200);
  EXPECT_EQ(find(plan, "threshold")->scene.threshold->at(0), 150);
  EXPECT_EQ(find(plan, "clipping")->scene.clipPlanes.at(0).point, Vec3(7, 8, 9));
}

/// Two effects of a lit scene, in three visits each: lighting left out, an isosurface added.
class EffectReports : public testing::Test {
 protected:
  EffectReports() {
    const SweepPlan planned = planEffects("a-0", litScene(), {});
    runs = {*find(planned, "lighting"), *find(planned, "isosurfaces")};
    PlannedRun baseline{.id = "a-0/baseline", .subject = "a-0", .kind = RunKind::baseline, .scene = litScene()};
    records.visits.push_back(visitOf(baseline.id, 0, 10, 1000));
    for (int round = 0; round < 3; ++round) {
      records.visits.push_back(visitOf(runs[0].id, round, 2, 500));
      records.visits.back().baseline = {8.0 + 2 * round, 30};
      records.visits.push_back(visitOf(runs[1].id, round, 15, 4000));
      records.visits.back().baseline = {10, 20};
    }
    records.references = {{runs[0].id, 1024, 1024, "images/without.png", 1, 1}};
    report.runs = summarise({baseline}, records);
    report.effects = summariseEffects(runs, report.runs, records);
  }

  static VisitRecord visitOf(const std::string& run, int round, double wall, std::size_t bytes) {
    VisitRecord record{.run = run, .round = round, .wallMs = wall, .cpuMs = 2 * wall};
    record.stagesMs = {{"draw", wall}};
    if (round > 0) return record;
    record.stagesMs.insert(record.stagesMs.begin(), {"gradients", 3});
    record.prepareMs = 3;
    Quality& quality = record.quality.emplace();
    quality.error = {1e-7, 1e-6, 1e-5, 100, 1};
    PlanItem target;
    target.kind = PlanKind::target;
    target.name = "colour";
    target.stage = "draw";
    target.bytes = bytes;
    quality.plan = {target};
    return record;
  }

  std::vector<PlannedRun> runs;
  StudyRecords records;
  StudyReport report;
};

// A frame with the effect over one without it, whichever of the two is the baseline; the median of the pairs.
TEST_F(EffectReports, RatiosAreOfThePairs) {
  const EffectReport &lighting = report.effects.at(0), &isosurfaces = report.effects.at(1);
  EXPECT_DOUBLE_EQ(lighting.wallRatio.median, 10.0 / 2);
  EXPECT_DOUBLE_EQ(lighting.wallRatio.least, 8.0 / 2);
  EXPECT_DOUBLE_EQ(lighting.wallRatio.most, 12.0 / 2);
  EXPECT_DOUBLE_EQ(lighting.cpuRatio.median, 30.0 / 4);
  EXPECT_DOUBLE_EQ(isosurfaces.wallRatio.median, 15.0 / 10);
  EXPECT_EQ(lighting.report.repetitions, 3);
  EXPECT_FALSE(lighting.report.onFront);
}

TEST_F(EffectReports, AreInTheJsonWithTheirLedger) {
  const Json study = Json::parse(studyJson(report));
  ASSERT_EQ(study["effects"].size(), 2U);
  const Json& lighting = study["effects"][0];
  EXPECT_EQ(lighting["effect"], "lighting");
  EXPECT_EQ(lighting["adds"], false);
  EXPECT_EQ(lighting["also"], Json{"shadows"});
  EXPECT_EQ(lighting["reference"], "images/without.png");
  EXPECT_TRUE(study["effects"][1]["reference"].is_null());
  EXPECT_EQ(lighting["wall_ratio"]["median"], 5);
  EXPECT_EQ(lighting["bytes"], 500);
  EXPECT_EQ(lighting["baseline"]["bytes"], 1000);
  EXPECT_EQ(lighting["baseline"]["id"], "a-0/baseline");
  EXPECT_EQ(lighting["prepare_ms"], 3);
  EXPECT_EQ(lighting["stages_ms"], (Json{{"gradients", 3}, {"draw", 2}}));
  const Json items{{{"kind", "target"}, {"name", "colour"}, {"bytes", 500}}};
  EXPECT_EQ(lighting["ledger"], (Json{{{"stage", "draw"}, {"ms", 2}, {"bytes", 500}, {"items", items}}}));
  EXPECT_EQ(study["runs"][0]["ledger"].size(), 1U);
}

TEST_F(EffectReports, AreRowsOfATable) {
  const std::string table = effectsCsv(report);
  EXPECT_EQ(std::count(table.begin(), table.end(), '\n'), 3);
  EXPECT_THAT(table, HasSubstr("a-0/without lighting"));
  EXPECT_THAT(table.substr(0, table.find('\n')), HasSubstr("wall_ratio.median"));
}

TEST_F(EffectReports, AreShownAsText) {
  const std::string text = effectsText(report, "a-0");
  EXPECT_THAT(text, HasSubstr("5.00"));
  EXPECT_THAT(text, HasSubstr("without lighting nor shadows"));
  EXPECT_EQ(effectsText(report, "b-0"), "");
}

TEST_F(EffectReports, AreToldWhereTheyFailed) {
  for (VisitRecord& visit : records.visits)
    if (visit.run == runs[1].id) visit = {.run = visit.run, .round = visit.round, .failed = "no memory"};
  report.effects = summariseEffects(runs, report.runs, records);
  EXPECT_EQ(Json::parse(studyJson(report))["effects"][1]["failed"], "no memory");
  EXPECT_THAT(studyText(report), HasSubstr("failed: a-0/with isosurfaces: no memory"));
}

}  // namespace
}  // namespace havs
