// study.json and study.csv.
#include <fmt/format.h>

#include <algorithm>

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
  json["bytes_per_pixel"] = quality.bytesPerPixel;
  json["image"] = textOrNull(quality.image);
  json["difference"] = textOrNull(quality.difference);
  json["on_front"] = report.onFront;
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

std::string csvField(const Json& value) {
  std::string text = value.is_string() ? value.get<std::string>() : value.is_null() ? "" : textOf(value);
  if (text.find_first_of(",\"\n") == std::string::npos) return text;
  for (std::size_t i = 0; (i = text.find('"', i)) != std::string::npos; i += 2) text.insert(i, "\"");
  return "\"" + text + "\"";
}

/// A JSON object as columns "a.b"; arrays as "1x2".
void flatten(const Json& json, const std::string& prefix, std::vector<std::pair<std::string, Json>>& columns) {
  for (const auto& [key, value] : json.items()) {
    if (value.is_object())
      flatten(value, prefix + key + ".", columns);
    else if (value.is_array())
      columns.emplace_back(prefix + key, fmt::format("{}x{}", textOf(value.at(0)), textOf(value.at(1))));
    else
      columns.emplace_back(prefix + key, value);
  }
}

}  // namespace

std::string studyJson(const StudyReport& report) {
  Json json{{"version", 1}, {"command", report.command}, {"created", report.created}, {"complete", report.complete}};
  json["machine"] = asJson(report.machine, report.device);
  json["subjects"] = listOf(report.subjects, report.references);
  json["axes"] = listOf(report.axes, report.baseline);
  json["runs"] = listOf(report.runs);
  json["fits"] = listOf(report.fits);
  json["skipped"] = report.skipped;
  json["effects"] = Json::array();
  return textOf(json, 2) + "\n";
}

std::string studyCsv(const StudyReport& report) {
  std::vector<std::string> header;
  std::vector<std::map<std::string, std::string>> rows;
  for (const RunReport& run : report.runs) {
    std::vector<std::pair<std::string, Json>> columns;
    flatten(asJson(run), "", columns);
    auto& row = rows.emplace_back();
    for (const auto& [name, value] : columns) {
      row[name] = csvField(value);
      if (std::find(header.begin(), header.end(), name) == header.end()) header.push_back(name);
    }
  }
  std::string text = fmt::format("{}\n", fmt::join(header, ","));
  for (auto& row : rows) {
    for (std::size_t i = 0; i < header.size(); ++i) text += (i > 0 ? "," : "") + row[header[i]];
    text += "\n";
  }
  return text;
}

}  // namespace havs
