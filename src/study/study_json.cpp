// study.json.
#include <fmt/format.h>

#include <algorithm>

#include "render/cost_ledger.h"
#include "render/effects.h"
#include "study/effect_runs.h"
#include "study/records_json.h"
#include "study/study_report.h"

namespace havs {
namespace {

using Json = nlohmann::ordered_json;

Json asJson(const Machine& machine, const DeviceRecord& device) {
  return {{"cpu", machine.cpu},           {"cores", machine.cores},
          {"threads", machine.threads},   {"memory_bytes", machine.memoryBytes},
          {"system", machine.system},     {"renderer", device.renderer},
          {"gl_version", device.version}, {"havs", machine.havs},
          {"compiler", machine.compiler}};
}

Json textOrNull(const std::string& text) { return text.empty() ? Json() : Json(text); }

/// The reference of the subject's own size; null where it has not been drawn.
Json referenceOf(const SubjectRecord& subject, const std::vector<ReferenceRecord>& references) {
  for (const ReferenceRecord& one : references)
    if (one.subject == subject.id && one.width == subject.width && one.height == subject.height) {
      Json json = toJson(one);
      json.erase("subject");
      return json;
    }
  return {};
}

Json asJson(const SubjectRecord& subject, const std::vector<ReferenceRecord>& references) {
  Json json = toJson(subject);
  json["camera"] = Json::parse(subject.camera);
  json["reference"] = referenceOf(subject, references);
  return json;
}

Json asJson(const AxisChoice& choice, const Scene& baseline) {
  return {{"name", choice.axis->name},
          {"title", choice.axis->title},
          {"values", choice.values},
          {"baseline", choice.axis->applies(baseline) ? Json(choice.axis->valueOf(baseline)) : Json()},
          {"ordered", choice.axis->ordered},
          {"across", textOrNull(choice.axis->across)}};
}

/// The text as a number where the axis has numbers.
Json valueJson(const StudyAxis& row, const std::string& text) {
  return row.ordered ? Json::parse(text, nullptr, false) : Json(text);
}

/// One key an axis, null where it has no effect.
Json settingsJson(const Scene& scene) {
  Json json;
  for (const StudyAxis& row : axes()) {
    std::string key = row.name;
    std::replace(key.begin(), key.end(), '-', '_');
    json[key] = row.applies(scene) ? valueJson(row, row.valueOf(scene)) : Json();
  }
  json["composite_late"] = scene.compositeLate;
  json["size"] = {scene.width, scene.height};
  return json;
}

Json asJson(const Spread& spread) {
  return {{"median", spread.median}, {"least", spread.least}, {"most", spread.most}};
}

Json stagesJson(const RunReport& run) {
  Json json = Json::object();
  for (const auto& [stage, milliseconds] : run.stagesMs) json[stage] = milliseconds;
  return json;
}

/// What each planned stage took and keeps.
Json ledgerOf(const RunReport& run) {
  const auto millisecondsOf = [&](const std::string& stage) {
    const auto found =
        std::find_if(run.stagesMs.begin(), run.stagesMs.end(), [&](const auto& one) { return one.first == stage; });
    return found == run.stagesMs.end() ? 0 : found->second;
  };
  Json ledger = Json::array();
  for (const LedgerStage& row : costLedger(run.quality->plan, millisecondsOf)) {
    Json items = Json::array();
    for (const PlanItem* item : row.items)
      items.push_back({{"kind", nameOf(item->kind)}, {"name", item->name}, {"bytes", item->bytes}});
    ledger.push_back({{"stage", row.stage}, {"ms", row.milliseconds}, {"bytes", row.bytes}, {"items", items}});
  }
  return ledger;
}

Json asJson(const RunReport& report) {
  Json json{{"id", report.run.id},
            {"subject", report.run.subject},
            {"kind", nameOf(report.run.kind)},
            {"axis", textOrNull(report.run.axis)},
            {"value", textOrNull(report.run.value)},
            {"label", settingsLabel(report.run.scene)},
            {"settings", settingsJson(report.run.scene)}};
  json["failed"] = textOrNull(report.failed);
  if (!report.failed.empty() || !report.quality) return json;
  const Quality& quality = *report.quality;
  json["error"] = toJson(quality.error);
  json["error_with_masked_pixels"] = toJson(quality.errorWithMasked);
  json["certificate"] = Json();
  if (quality.certificate)
    json["certificate"] = {{"misordered", (*quality.certificate)[0]}, {"pixels", (*quality.certificate)[1]}};
  json["repetitions"] = report.repetitions;
  json["frame_wall_ms"] = asJson(report.wallMs);
  json["frame_cpu_ms"] = asJson(report.cpuMs);
  json["table_ms"] = report.tableMs;
  json["prepare_ms"] = report.prepareMs;
  json["stages_ms"] = stagesJson(report);
  json["bytes_per_pixel"] = quality.bytesPerPixel;
  json["bytes"] = plannedBytes(report);
  json["ledger"] = ledgerOf(report);
  json["image"] = textOrNull(quality.image);
  json["difference"] = textOrNull(quality.difference);
  json["on_front"] = report.onFront;
  return json;
}

std::string descriptionOf(const std::string& effect) {
  for (const Effect& row : effects())
    if (row.name == effect) return row.description;
  return "";
}

/// A run, and what is said of the baseline beside it.
Json asJson(const EffectReport& effect) {
  const RunReport& report = effect.report;
  Json json = asJson(report);
  for (const char* key : {"axis", "value", "on_front"}) json.erase(key);
  json["label"] = effectLabel(report.run);
  json["effect"] = report.run.effect;
  json["description"] = descriptionOf(report.run.effect);
  json["adds"] = report.run.adds;
  json["also"] = report.run.also;
  if (!report.failed.empty() || !report.quality) return json;
  json["reference"] = effect.reference ? textOrNull(effect.reference->image) : Json();
  json["wall_ratio"] = asJson(effect.wallRatio);
  json["cpu_ratio"] = asJson(effect.cpuRatio);
  json["baseline"] = {{"id", effect.baseline.run.id},
                      {"frame_wall_ms", asJson(effect.baselineWallMs)},
                      {"frame_cpu_ms", asJson(effect.baselineCpuMs)}};
  if (!effect.baseline.quality) return json;
  json["baseline"]["prepare_ms"] = effect.baseline.prepareMs;
  json["baseline"]["bytes"] = plannedBytes(effect.baseline);
  json["baseline"]["error"] = toJson(effect.baseline.quality->error);
  return json;
}

Json asJson(const FitReport& fit) {
  return {
      {"subject", fit.subject}, {"axis", fit.axis},     {"lookup", fit.lookup}, {"measure", fit.measure},
      {"slope", fit.fit.slope}, {"points", fit.points}, {"used", fit.fit.used}, {"worst_factor", fit.fit.worstFactor}};
}

template <class Rows, class... More>
Json listOf(const Rows& rows, const More&... more) {
  Json list = Json::array();
  for (const auto& row : rows) list.push_back(asJson(row, more...));
  return list;
}

}  // namespace

std::string studyJson(const StudyReport& report) {
  Json json{{"version", 1}, {"command", report.command}, {"created", report.created}, {"complete", report.complete}};
  json["machine"] = asJson(report.machine, report.device);
  json["subjects"] = listOf(report.subjects, report.references);
  json["axes"] = listOf(report.axes, report.baseline);
  json["runs"] = runsJson(report);
  json["fits"] = listOf(report.fits);
  json["skipped"] = report.skipped;
  json["effects"] = effectsJson(report);
  return textOf(json, 2) + "\n";
}

nlohmann::ordered_json runsJson(const StudyReport& report) { return listOf(report.runs); }

nlohmann::ordered_json effectsJson(const StudyReport& report) { return listOf(report.effects); }

}  // namespace havs
