#include "app/plan_report.h"

#include <fmt/format.h>

#include <array>

#include "render/cost_ledger.h"

namespace havs {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::array kKinds{PlanKind::precomputation, PlanKind::vertexData, PlanKind::table,
                            PlanKind::program,        PlanKind::target,     PlanKind::pass};

std::string sizeOf(const PlanItem& item) {
  if (item.bytes == 0) return "";
  const double megabytes = static_cast<double>(item.bytes) / 1e6;
  const std::string total = megabytes < 0.1 ? fmt::format("{} bytes", item.bytes) : fmt::format("{:.1f} MB", megabytes);
  return item.of.empty() ? " (" + total + ")" : fmt::format(" ({} bytes each {}, {})", item.bytesEach, item.of, total);
}

Json orNull(const std::string& text) { return text.empty() ? Json() : Json(text); }

Json itemAsJson(const PlanItem& item) {
  return {{"kind", nameOf(item.kind)},   {"name", item.name},   {"reason", item.reason},
          {"stage", orNull(item.stage)}, {"bytes", item.bytes}, {"bytes_each", item.bytesEach},
          {"of", orNull(item.of)}};
}

}  // namespace

std::string planAsText(std::span<const PlanItem> items) {
  std::string text;
  for (const PlanKind kind : kKinds) {
    std::string lines;
    for (const PlanItem& item : items)
      if (item.kind == kind) lines += fmt::format("  {}{}\n      {}\n", item.name, sizeOf(item), item.reason);
    text += fmt::format("{}{}\n{}", nameOf(kind), lines.empty() ? ": none" : "", lines);
  }
  return text;
}

Json planAsJson(std::span<const PlanItem> items) {
  Json json = Json::array();
  for (const PlanItem& item : items) json.push_back(itemAsJson(item));
  return json;
}

Json ledgerAsJson(std::span<const PlanItem> items, const StageTimes& stages) {
  Json ledger = Json::array();
  for (const LedgerStage& row : costLedger(items, [&](const std::string& stage) { return stages.median(stage); })) {
    Json ofStage = Json::array();
    for (const PlanItem* item : row.items)
      ofStage.push_back(
          {{"kind", nameOf(item->kind)}, {"name", item->name}, {"bytes", item->bytes}, {"reason", item->reason}});
    ledger.push_back({{"stage", row.stage}, {"ms", row.milliseconds}, {"bytes", row.bytes}, {"items", ofStage}});
  }
  return ledger;
}

}  // namespace havs
