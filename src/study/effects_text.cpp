// What effects cost, for people.
#include <fmt/format.h>

#include "study/effect_runs.h"
#include "study/study_report.h"

namespace havs {
namespace {

constexpr double kMegabyte = 1e6;

std::string rowOf(const EffectReport& effect) {
  const RunReport &with = effect.report.run.adds ? effect.report : effect.baseline,
                  &without = effect.report.run.adds ? effect.baseline : effect.report;
  const double bytes =
      (static_cast<double>(plannedBytes(with)) - static_cast<double>(plannedBytes(without))) / kMegabyte;
  return fmt::format("  {:>8.2f} {:>8.2f} {:>11.1f} {:>10.2f} {:>9.2e}  {}\n", effect.wallRatio.median,
                     effect.cpuRatio.median, with.prepareMs - without.prepareMs, bytes,
                     effect.report.quality->error.p999, effectLabel(effect.report.run));
}

}  // namespace

std::string effectsText(const StudyReport& report, const std::string& subject) {
  std::string text;
  for (const EffectReport& effect : report.effects)
    if (effect.report.run.subject == subject && effect.report.quality && effect.report.failed.empty())
      text += rowOf(effect);
  if (text.empty()) return "";
  return fmt::format("  {:>8} {:>8} {:>11} {:>10} {:>9}  {}\n", "times", "CPU", "ms once", "MB", "99.9%",
                     "effects: a frame with over one without; what it adds") +
         text;
}

}  // namespace havs
