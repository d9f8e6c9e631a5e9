#pragma once
// What the things that a plan lists cost, stage by stage.
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "render/plan_item.h"

namespace havs {

/// A planned stage: what it took, and what is kept for it.
struct LedgerStage {
  std::string stage;                   ///< of StageTimes
  double milliseconds = 0;             ///< wall
  std::size_t bytes = 0;               ///< sum over its items
  std::vector<const PlanItem*> items;  ///< of the plan, which must live longer
};

/// The stages of the items, in the order in which they come first. Items without a stage (programs) are in none.
/// `millisecondsOf`: a stage's time; 0 where it did not run.
std::vector<LedgerStage> costLedger(std::span<const PlanItem> items,
                                    const std::function<double(const std::string& stage)>& millisecondsOf);

}  // namespace havs
