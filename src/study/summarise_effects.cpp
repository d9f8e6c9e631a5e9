// What each effect costs beside the baseline.
#include <algorithm>
#include <numeric>

#include "core/median.h"
#include "study/study_report.h"

namespace havs {
namespace {

const RunReport* baselineOf(const std::vector<RunReport>& runs, const std::string& subject) {
  for (const RunReport& run : runs)
    if (run.run.subject == subject && run.run.kind == RunKind::baseline) return &run;
  return nullptr;
}

void addTimes(EffectReport& effect, const StudyRecords& records) {
  const bool adds = effect.report.run.adds;
  std::vector<double> wall, cpu, wallRatio, cpuRatio;
  for (const VisitRecord& visit : records.visits) {
    if (visit.run != effect.report.run.id || !visit.baseline) continue;
    wall.push_back(visit.baseline->wallMs);
    cpu.push_back(visit.baseline->cpuMs);
    const auto ratio = [&](double changed, double baseline, std::vector<double>& to) {
      const double with = adds ? changed : baseline, without = adds ? baseline : changed;
      if (without > 0) to.push_back(with / without);
    };
    ratio(visit.wallMs, visit.baseline->wallMs, wallRatio);
    ratio(visit.cpuMs, visit.baseline->cpuMs, cpuRatio);
  }
  effect.baselineWallMs = spreadOf(wall);
  effect.baselineCpuMs = spreadOf(cpu);
  effect.wallRatio = spreadOf(wallRatio);
  effect.cpuRatio = spreadOf(cpuRatio);
}

}  // namespace

std::size_t plannedBytes(const RunReport& run) {
  if (!run.quality) return 0;
  const auto& plan = run.quality->plan;
  return std::accumulate(plan.begin(), plan.end(), std::size_t{0},
                         [](std::size_t sum, const PlanItem& item) { return sum + item.bytes; });
}

std::vector<EffectReport> summariseEffects(const std::vector<PlannedRun>& effects, const std::vector<RunReport>& runs,
                                           const StudyRecords& records) {
  std::vector<EffectReport> reports;
  for (RunReport& run : summarise(effects, records)) {
    EffectReport& effect = reports.emplace_back();
    effect.report = std::move(run);
    effect.report.onFront = false;  // of other pictures than the subject's
    if (const RunReport* baseline = baselineOf(runs, effect.report.run.subject)) effect.baseline = *baseline;
    addTimes(effect, records);
    for (const ReferenceRecord& one : records.references)
      if (one.subject == effect.report.run.id) effect.reference = one;
  }
  return reports;
}

}  // namespace havs
