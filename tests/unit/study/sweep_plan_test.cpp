#include "study/sweep_plan.h"

#include <gmock/gmock.h>

#include <map>
#include <optional>
#include <set>

#include "render/lookups.h"
#include "render/plan.h"

namespace havs {
namespace {

using testing::Contains;
using testing::Each;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::UnorderedElementsAre;

std::vector<AxisChoice> choose(const std::vector<std::string>& texts) { return chooseAxes(texts, false); }

std::vector<std::string> idsOf(const std::vector<PlannedRun>& runs) {
  std::vector<std::string> ids;
  for (const PlannedRun& run : runs) ids.push_back(run.id);
  return ids;
}

TEST(PlanSweep, DrawsNothingTwice) {
  const SweepPlan plan = planSweep("a-0", Scene{}, choose({}));
  std::set<std::string> ids, keys;
  for (const PlannedRun& run : plan.runs) {
    EXPECT_TRUE(ids.insert(run.id).second) << run.id;
    EXPECT_TRUE(keys.insert(settingsKey(run.scene)).second) << run.id;
  }
}

TEST(PlanSweep, BeginsWithTheBaselineAndHasThePapersChoice) {
  Scene baseline;
  baseline.k = 4;
  const SweepPlan plan = planSweep("a-0", baseline, choose({"k=2,4"}));
  EXPECT_THAT(idsOf(plan.runs), UnorderedElementsAre("a-0/baseline", "a-0/paper", "a-0/k=2"));
  EXPECT_EQ(plan.runs[0].kind, RunKind::baseline);
  EXPECT_EQ(plan.runs[0].scene.k, 4);
  EXPECT_EQ(plan.runs[1].kind, RunKind::paper);
  EXPECT_EQ(plan.runs[1].scene.lookup, "3d");  // whatever the defaults
  EXPECT_EQ(tableSizeOf(plan.runs[1].scene), 128);
  EXPECT_EQ(plan.runs[1].scene.tableFormat, "rgba8");
  EXPECT_EQ(plan.runs[1].scene.sort, "centroid");
}

/// A difference in error or time then has one cause.
TEST(PlanSweep, MovesOneAxisAtATime) {
  const Scene baseline;
  for (const StudyAxis& row : axes()) {
    if (!row.across.empty()) continue;  // swept around other baselines as well
    for (const PlannedRun& run : planSweep("a-0", baseline, choose({row.name})).runs) {
      if (run.kind != RunKind::axis) continue;
      EXPECT_EQ(run.axis, row.name);
      Scene back = run.scene;
      EXPECT_EQ(row.valueOf(back), run.value);
      row.apply(back, row.valueOf(baseline));
      EXPECT_EQ(settingsKey(back), settingsKey(baseline)) << run.id;
    }
  }
}

TEST(PlanSweep, SweepsTheTableOfEachLookupThatHasOne) {
  const SweepPlan plan = planSweep("a-0", Scene{}, choose({"table=16,128", "lookup"}));
  std::map<std::string, std::set<int>> swept;
  for (const PlannedRun& run : plan.runs)
    if (run.axis == "table" && !swept[run.scene.lookup].insert(tableSizeOf(run.scene)).second)
      ADD_FAILURE() << run.id << " is drawn twice";
  for (const Lookup& row : lookups()) {
    std::set<int> sizes;
    if (const LookupResource* table = tableOf(row)) {
      sizes = {16, 128};
      sizes.erase(table->ownSize);  // a run of the axis lookup, or the baseline
    }
    EXPECT_EQ(swept[exampleName(row)], sizes) << row.name;
  }
}

/// --table holds for every lookup; without it each has its own size.
TEST(PlanSweep, GivesEachLookupTheTableAskedForOrItsOwn) {
  for (const std::optional<int> asked : {std::optional<int>{}, std::optional<int>{24}}) {
    Scene baseline;
    baseline.tableSize = asked;
    for (const PlannedRun& run : planSweep("a-0", baseline, choose({"lookup"})).runs) {
      const LookupResource* table = tableOf(lookup(run.scene.lookup));
      if (table == nullptr || run.kind == RunKind::paper) continue;
      EXPECT_EQ(tableSizeOf(run.scene), asked.value_or(table->ownSize)) << run.id;
    }
  }
}

TEST(PlanSweep, SaysWhatItLeavesOut) {
  Scene baseline;
  baseline.lookup = "post";
  const SweepPlan plan = planSweep("a-0", baseline, choose({"table=16,32", "k=2,99"}));
  EXPECT_THAT(idsOf(plan.runs), UnorderedElementsAre("a-0/baseline", "a-0/paper", "a-0/k=2"));
  EXPECT_THAT(plan.skipped, Contains(HasSubstr("table: has no effect")));
  EXPECT_THAT(plan.skipped, Contains(HasSubstr("k=99: k is 99")));
}

std::map<std::string, CostError> measure(const SweepPlan& plan, CostError (*of)(const Scene&)) {
  std::map<std::string, CostError> measured;
  for (const PlannedRun& run : plan.runs) measured[run.id] = of(run.scene);
  return measured;
}

/// k costs time only; a small table costs accuracy only.
CostError madeUp(const Scene& scene) {
  const int size = tableSizeOf(scene);
  return {scene.k * 1.0, size < 128 ? 1.0 / size : 1e-3};
}

TEST(PlanCombinations, CombinesWhatIsNotDominated) {
  const auto choices = choose({"k=1,2,6,14", "table=16,128,256"});
  Scene baseline;
  baseline.tableSize = 128;
  const SweepPlan plan = planSweep("a-0", baseline, choices);
  // k 1 dominates the other k; of the tables, all that cost the same and err less than the others.
  const auto runs = planCombinations(plan, choices, measure(plan, madeUp), 10);
  EXPECT_THAT(idsOf(runs), UnorderedElementsAre("a-0/k=1,table=256"));
  EXPECT_EQ(runs.at(0).kind, RunKind::front);
  EXPECT_EQ(runs.at(0).scene.k, 1);
  EXPECT_EQ(runs.at(0).scene.tableSize, 256);
}

TEST(PlanCombinations, KeepsToItsNumberAndToNewSettings) {
  const auto choices = choose({"k=1,2,3,6,14", "table=8,16,32,64", "early-termination", "sort", "size=64,512"});
  const SweepPlan plan = planSweep("a-0", Scene{}, choices);
  const auto everyValueIsGood = [](const Scene& s) {
    const double cost = s.k + 0.01 * tableSizeOf(s) - 2 * s.earlyTermination + (s.sort == "none" ? -1 : 0);
    return CostError{20 + cost, 0.01 * (20 - cost)};
  };
  const auto measured = measure(plan, everyValueIsGood);
  std::set<std::string> known;
  for (const PlannedRun& run : plan.runs) known.insert(settingsKey(run.scene));
  for (const std::size_t most : {0u, 1u, 7u, 20u}) {
    const auto runs = planCombinations(plan, choices, measured, most);
    EXPECT_EQ(runs.size(), most);
    std::set<std::string> own = known;
    for (const PlannedRun& run : runs) {
      EXPECT_TRUE(own.insert(settingsKey(run.scene)).second) << run.id;
      EXPECT_EQ(run.scene.width, Scene{}.width) << "another size cannot be compared";
    }
  }
}

/// The cheapest value of all is one that leaves the picture out.
TEST(PlanCombinations, LeavesOutWhatIsNoPictureAnyMore) {
  const auto choices = choose({"k=1,6", "sort=none,topological"});
  const SweepPlan plan = planSweep("a-0", Scene{}, choices);
  const auto measured = measure(plan, [](const Scene& s) {
    return CostError{s.k * 1.0 - (s.sort == "none" ? 0.5 : 0), s.sort == "none" ? 0.8 : 0.01};
  });
  EXPECT_THAT(idsOf(planCombinations(plan, choices, measured, 10)), IsEmpty());
}

/// A study that was interrupted chooses again.
TEST(PlanCombinations, IsTheSameForTheSameMeasurements) {
  const auto choices = choose({"k", "table", "early-termination"});
  const SweepPlan plan = planSweep("a-0", Scene{}, choices);
  const auto measured = measure(plan, madeUp);
  EXPECT_EQ(idsOf(planCombinations(plan, choices, measured, 5)), idsOf(planCombinations(plan, choices, measured, 5)));
}

TEST(PlanCombinations, NeedsABaselineThatCouldBeDrawn) {
  const auto choices = choose({"k"});
  EXPECT_THAT(planCombinations(planSweep("a-0", Scene{}, choices), choices, {}, 5), IsEmpty());
}

}  // namespace
}  // namespace havs
