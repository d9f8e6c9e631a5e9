#pragma once
// A plan as `havs plan` prints it, and the cost ledger of a picture.
#include <nlohmann/json.hpp>
#include <span>
#include <string>

#include "core/stage_times.h"
#include "render/plan_item.h"

namespace havs {

/// One line an item, grouped by kind: what, how large, why.
std::string planAsText(std::span<const PlanItem> items);

/// An array of {kind, name, reason, stage, bytes, bytes_each, of}; stage and of are null where there is none.
nlohmann::ordered_json planAsJson(std::span<const PlanItem> items);

/// What each planned stage took: an array of {stage, ms, bytes, items}, in the order in which the stages come in the
/// plan; ms is the median of the stage's runs, bytes the sum of what its items keep.
nlohmann::ordered_json ledgerAsJson(std::span<const PlanItem> items, const StageTimes& stages);

}  // namespace havs
