#include "study/effect_runs.h"

#include <fmt/format.h>

#include "core/error.h"

namespace havs {
namespace {

/// Others that the two scenes do not have alike.
std::vector<std::string> alsoChanged(const Effect& changed, const Scene& before, const Scene& after) {
  std::vector<std::string> names;
  for (const Effect& other : effects())
    if (other.name != changed.name && other.wanted(before) != other.wanted(after)) names.push_back(other.name);
  return names;
}

}  // namespace

SweepPlan planEffects(const std::string& subject, const Scene& baseline, const EffectData& data) {
  SweepPlan plan;
  for (const Effect& effect : effects()) {
    PlannedRun run{.subject = subject, .kind = RunKind::effect, .scene = baseline};
    run.effect = effect.name;
    run.adds = !effect.wanted(baseline);
    run.id = subject + (run.adds ? "/with " : "/without ") + effect.name;
    if (run.adds ? effect.add == nullptr : effect.remove == nullptr) {
      plan.skipped.push_back(run.id + ": it has no default form");
      continue;
    }
    if (run.adds)
      effect.add(run.scene, data);
    else
      effect.remove(run.scene);
    run.also = alsoChanged(effect, baseline, run.scene);
    try {
      checkScene(run.scene);
      plan.runs.push_back(std::move(run));
    } catch (const Error& error) {
      plan.skipped.push_back(run.id + ": " + error.what());
    }
  }
  return plan;
}

std::string effectLabel(const PlannedRun& run) {
  std::string label = (run.adds ? "with " : "without ") + run.effect;
  for (const std::string& name : run.also) label += (run.adds ? " and " : " nor ") + name;
  return label;
}

}  // namespace havs
