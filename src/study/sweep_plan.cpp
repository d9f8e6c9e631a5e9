#include "study/sweep_plan.h"

#include <algorithm>
#include <set>

#include "core/error.h"
#include "render/plan.h"

namespace havs {
namespace {

/// Collects runs, leaving out what is there already or cannot be.
class Collector {
 public:
  Collector(std::string subject, SweepPlan& plan) : subject_(std::move(subject)), plan_(plan) {}

  void add(RunKind kind, const std::string& name, const Scene& scene, const std::string& axis = "",
           const std::string& value = "") {
    try {
      checkScene(scene);
    } catch (const Error& error) {
      plan_.skipped.push_back(subject_ + "/" + name + ": " + error.what());
      return;
    }
    if (keys_.insert(settingsKey(scene)).second)
      plan_.runs.push_back({subject_ + "/" + name, subject_, kind, axis, value, scene});
  }

  void skip(const std::string& reason) { plan_.skipped.push_back(subject_ + "/" + reason); }

 private:
  std::string subject_;
  SweepPlan& plan_;
  std::set<std::string> keys_;
};

/// Adds each value of the axis around `around`; false where the axis has no effect there.
bool sweepAround(Collector& runs, const Scene& around, const AxisChoice& choice, const std::string& prefix) {
  if (!choice.axis->applies(around)) return false;
  for (const std::string& value : choice.values) {
    Scene scene = around;
    choice.axis->apply(scene, value);
    runs.add(RunKind::axis, prefix + choice.axis->name + "=" + value, scene, choice.axis->name, value);
  }
  return true;
}

const AxisChoice* find(std::span<const AxisChoice> choices, const std::string& name) {
  for (const AxisChoice& choice : choices)
    if (choice.axis->name == name) return &choice;
  return nullptr;
}

void sweep(Collector& runs, const Scene& baseline, const AxisChoice& choice, std::span<const AxisChoice> choices) {
  bool applies = sweepAround(runs, baseline, choice, "");
  if (const AxisChoice* across = find(choices, choice.axis->across))
    for (const std::string& value : across->values) {
      Scene around = baseline;
      across->axis->apply(around, value);
      applies = sweepAround(runs, around, choice, across->axis->name + "=" + value + ",") || applies;
    }
  if (!applies) runs.skip(choice.axis->name + ": has no effect with these settings");
}

/// An error that is no picture of the data any more: cheap, but not worth combining.
constexpr double kUseless = 0.25;

/// A value of an axis, and what it changes of the baseline.
struct Step {
  const StudyAxis* axis = nullptr;
  std::string value;
  double costFactor = 1;
  double errorFactor = 1;  ///< at most 1
  double errorAdded = 0;
};

/// The values of one axis worth combining; the first is the baseline's.
std::vector<Step> goodSteps(const SweepPlan& plan, const AxisChoice& choice,
                            const std::map<std::string, CostError>& measured) {
  const PlannedRun& baseline = plan.runs.front();
  const CostError from = measured.at(baseline.id);
  std::vector<Step> steps{{choice.axis, choice.axis->valueOf(baseline.scene), 1, 1, 0}};
  std::vector<CostError> points{from};
  for (const PlannedRun& run : plan.runs) {
    const auto found = measured.find(run.id);
    // Of an axis swept across another, only the sweep around the baseline isolates it.
    const bool isolated = run.id == run.subject + "/" + run.axis + "=" + run.value;
    if (run.axis != choice.axis->name || !isolated || found == measured.end()) continue;
    const double cost = found->second.cost / from.cost, error = found->second.error;
    steps.push_back({choice.axis, run.value, cost, from.error > 0 ? std::min(1.0, error / from.error) : 1.0,
                     std::max(0.0, error - from.error)});
    points.push_back(found->second);
  }
  const std::vector<bool> good = nonDominated(points);
  std::vector<Step> kept{steps.front()};
  for (std::size_t i = 1; i < steps.size(); ++i)
    if (good[i] && points[i].error <= std::max(kUseless, from.error)) kept.push_back(steps[i]);
  return kept;
}

struct Combination {
  PlannedRun run;
  CostError expected;
};

Combination combine(const PlannedRun& baseline, CostError from, std::span<const Step> steps) {
  Combination result{baseline, from};
  double added = 0;
  std::string name;
  for (const Step& step : steps) {
    if (step.value == step.axis->valueOf(baseline.scene)) continue;
    step.axis->apply(result.run.scene, step.value);
    name += (name.empty() ? "" : ",") + step.axis->name + "=" + step.value;
    result.expected.cost *= step.costFactor;
    result.expected.error *= step.errorFactor;
    added += step.errorAdded;
  }
  result.expected.error += added;
  result.run.kind = RunKind::front;
  result.run.id = baseline.subject + "/" + name;
  return result;
}

bool isAllowed(const Scene& scene) {
  try {
    checkScene(scene);
    return true;
  } catch (const Error&) {
    return false;
  }
}

/// One more axis: every combination so far with every step of it.
std::vector<std::vector<Step>> extended(const std::vector<std::vector<Step>>& all, const std::vector<Step>& steps) {
  std::vector<std::vector<Step>> result;
  for (const auto& one : all)
    for (const Step& step : steps) {
      result.push_back(one);
      result.back().push_back(step);
    }
  return result;
}

}  // namespace

SweepPlan planSweep(const std::string& subject, const Scene& baseline, std::span<const AxisChoice> choices) {
  SweepPlan plan;
  Collector runs(subject, plan);
  runs.add(RunKind::baseline, "baseline", baseline);
  Scene paper = baseline;
  applyPaperPreset(paper);
  if (!choices.empty()) runs.add(RunKind::paper, "paper", paper);
  // First what isolates an axis, so that a setting met twice is told as a value of that one.
  for (const bool across : {false, true})
    for (const AxisChoice& choice : choices)
      if (choice.axis->across.empty() != across) sweep(runs, baseline, choice, choices);
  return plan;
}

std::vector<PlannedRun> planCombinations(const SweepPlan& plan, std::span<const AxisChoice> choices,
                                         const std::map<std::string, CostError>& measured, std::size_t most) {
  constexpr std::size_t kMostConsidered = 100000;
  if (plan.runs.empty() || !measured.contains(plan.runs.front().id)) return {};
  const PlannedRun& baseline = plan.runs.front();
  std::vector<std::vector<Step>> all{{}};
  for (const AxisChoice& choice : choices) {
    if (choice.axis->changesPicture) continue;
    const std::vector<Step> steps = goodSteps(plan, choice, measured);
    if (all.size() * steps.size() <= kMostConsidered) all = extended(all, steps);
  }
  std::set<std::string> known;
  for (const PlannedRun& run : plan.runs) known.insert(settingsKey(run.scene));
  std::vector<PlannedRun> candidates;
  std::vector<CostError> expected;
  for (const auto& steps : all) {
    Combination one = combine(baseline, measured.at(baseline.id), steps);
    if (!isAllowed(one.run.scene) || !known.insert(settingsKey(one.run.scene)).second) continue;
    candidates.push_back(std::move(one.run));
    expected.push_back(one.expected);
  }
  std::vector<PlannedRun> chosen;
  for (const std::size_t i : bestOf(expected, most)) chosen.push_back(candidates[i]);
  return chosen;
}

}  // namespace havs
