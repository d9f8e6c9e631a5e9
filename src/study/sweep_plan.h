#pragma once
#include <map>
#include <span>
#include <string>
#include <vector>

#include "study/axes.h"
#include "study/front.h"
#include "study/records.h"

namespace havs {

/// What is to be measured on one subject, and what is not, and why.
struct SweepPlan {
  std::vector<PlannedRun> runs;  ///< the baseline first; no two with the same settings
  std::vector<std::string> skipped;
};

/// The baseline, the paper's own choice where there are axes, and each value of each axis with all other settings as in
/// the baseline
/// (`table` also with each value of `lookup` that reads a table, where both are chosen). Values without effect, and
/// scenes that checkScene refuses, are skipped.
SweepPlan planSweep(const std::string& subject, const Scene& baseline, std::span<const AxisChoice> choices);

/// Combinations of values that did well: of each axis the values that no other value of that axis dominates (the
/// baseline's is one of them; errors beyond a quarter are not), all combined, those measured already left out; of these
/// the `most` most promising, by the front of what they should cost and err: the baseline's cost times each value's
/// factor; the baseline's error times the factors of values that better it, plus what the others add to it. Axes that
/// change the picture stay as they are. `measured`: what is known of runs of `plan`, by id.
std::vector<PlannedRun> planCombinations(const SweepPlan& plan, std::span<const AxisChoice> choices,
                                         const std::map<std::string, CostError>& measured, std::size_t most);

}  // namespace havs
