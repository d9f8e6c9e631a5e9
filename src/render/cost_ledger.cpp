#include "render/cost_ledger.h"

#include <algorithm>

namespace havs {

std::vector<LedgerStage> costLedger(std::span<const PlanItem> items,
                                    const std::function<double(const std::string& stage)>& millisecondsOf) {
  std::vector<LedgerStage> ledger;
  for (const PlanItem& item : items) {
    if (item.stage.empty()) continue;
    auto found = std::find_if(ledger.begin(), ledger.end(), [&](const auto& row) { return row.stage == item.stage; });
    if (found == ledger.end()) found = ledger.insert(ledger.end(), {item.stage, millisecondsOf(item.stage), 0, {}});
    found->bytes += item.bytes;
    found->items.push_back(&item);
  }
  return ledger;
}

}  // namespace havs
