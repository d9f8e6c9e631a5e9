#include "study/records_json.h"

#include <array>
#include <cmath>
#include <limits>

namespace havs {
namespace {

using Json = nlohmann::ordered_json;

ErrorMeasures errorFrom(const Json& json) {
  const Json &psnr = json.at("psnr"), &ssim = json.at("ssim");
  return {json.at("rmse"), json.at("p999"), json.at("max"),
          psnr.is_null() ? std::numeric_limits<double>::infinity() : psnr.get<double>(),
          ssim.is_null() ? std::numeric_limits<double>::quiet_NaN() : ssim.get<double>()};
}

constexpr std::array kKinds{PlanKind::pass,   PlanKind::program, PlanKind::vertexData,
                            PlanKind::target, PlanKind::table,   PlanKind::precomputation};

Json toJson(const PlanItem& item) {
  return {{"kind", nameOf(item.kind)}, {"name", item.name}, {"stage", item.stage}, {"bytes", item.bytes}};
}

PlanItem itemFrom(const Json& json) {
  PlanItem item;
  for (const PlanKind kind : kKinds)
    if (json.at("kind") == nameOf(kind)) item.kind = kind;
  item.name = json.at("name");
  item.stage = json.at("stage");
  item.bytes = json.at("bytes");
  return item;
}

Json toJson(const StageMilliseconds& stages) {
  Json json = Json::object();
  for (const auto& [stage, milliseconds] : stages) json[stage] = milliseconds;
  return json;
}

Json toJson(const Quality& quality) {
  Json json;
  json["error"] = havs::toJson(quality.error);
  json["error_with_masked_pixels"] = havs::toJson(quality.errorWithMasked);
  json["certificate"] = quality.certificate ? Json(*quality.certificate) : Json();
  json["bytes_per_pixel"] = quality.bytesPerPixel;
  json["plan"] = Json::array();
  for (const PlanItem& item : quality.plan) json["plan"].push_back(toJson(item));
  json["image"] = quality.image;
  json["difference"] = quality.difference;
  return json;
}

Quality qualityFrom(const Json& json) {
  Quality quality;
  quality.error = errorFrom(json.at("error"));
  quality.errorWithMasked = errorFrom(json.at("error_with_masked_pixels"));
  if (!json.at("certificate").is_null()) quality.certificate = json.at("certificate").get<std::array<std::size_t, 2>>();
  quality.bytesPerPixel = json.at("bytes_per_pixel");
  const Json plan = json.value("plan", Json::array());
  for (const Json& item : plan) quality.plan.push_back(itemFrom(item));
  quality.image = json.at("image");
  quality.difference = json.at("difference");
  return quality;
}

}  // namespace

std::string nameOf(RunKind kind) {
  switch (kind) {
    case RunKind::baseline:
      return "baseline";
    case RunKind::axis:
      return "axis";
    case RunKind::paper:
      return "paper";
    case RunKind::front:
      return "front";
    case RunKind::effect:
      return "effect";
  }
  return "";
}

Json toJson(const ErrorMeasures& error) {
  return {{"rmse", error.rmse},
          {"p999", error.p999},
          {"max", error.max},
          {"psnr", std::isfinite(error.psnr) ? Json(error.psnr) : Json()},
          {"ssim", std::isfinite(error.ssim) ? Json(error.ssim) : Json()}};
}

Json toJson(const VisitRecord& record) {
  Json json{{"run", record.run}, {"round", record.round}};
  if (!record.failed.empty()) {
    json["failed"] = record.failed;
    return json;
  }
  json["wall_ms"] = record.wallMs;
  json["cpu_ms"] = record.cpuMs;
  json["stages_ms"] = toJson(record.stagesMs);
  if (record.tableMs) json["table_ms"] = *record.tableMs;
  if (record.prepareMs) json["prepare_ms"] = *record.prepareMs;
  if (record.baseline) json["baseline"] = {{"wall_ms", record.baseline->wallMs}, {"cpu_ms", record.baseline->cpuMs}};
  if (record.quality) json["quality"] = toJson(*record.quality);
  return json;
}

VisitRecord visitFrom(const Json& json) {
  VisitRecord record;
  record.run = json.at("run");
  record.round = json.at("round");
  if (json.contains("failed")) {
    record.failed = json.at("failed");
    return record;
  }
  record.wallMs = json.at("wall_ms");
  record.cpuMs = json.at("cpu_ms");
  const Json stages = json.value("stages_ms", Json::object());
  for (const auto& [stage, milliseconds] : stages.items())
    record.stagesMs.emplace_back(stage, milliseconds.get<double>());
  if (json.contains("table_ms")) record.tableMs = json.at("table_ms").get<double>();
  if (json.contains("prepare_ms")) record.prepareMs = json.at("prepare_ms").get<double>();
  if (json.contains("baseline")) record.baseline = {json["baseline"].at("wall_ms"), json["baseline"].at("cpu_ms")};
  if (json.contains("quality")) record.quality = qualityFrom(json.at("quality"));
  return record;
}

Json toJson(const SubjectRecord& record) {
  return {{"id", record.id},
          {"mesh", record.mesh},
          {"content", record.content},
          {"points", record.points},
          {"cells", record.cells},
          {"faces", record.faces},
          {"field", record.field},
          {"transfer_function", record.transferFunction},
          {"camera", record.camera},
          {"size", {record.width, record.height}},
          {"masked_pixels", record.maskedPixels}};
}

SubjectRecord subjectFrom(const Json& json) {
  return {json.at("id"),     json.at("mesh"),       json.at("content"),    json.at("points"),
          json.at("cells"),  json.at("faces"),      json.at("field"),      json.at("transfer_function"),
          json.at("camera"), json.at("size").at(0), json.at("size").at(1), json.at("masked_pixels")};
}

Json toJson(const ReferenceRecord& record) {
  return {{"subject", record.subject},
          {"size", {record.width, record.height}},
          {"image", record.image},
          {"wall_ms", record.wallMs},
          {"cpu_ms", record.cpuMs}};
}

ReferenceRecord referenceFrom(const Json& json) {
  return {json.at("subject"), json.at("size").at(0), json.at("size").at(1),
          json.at("image"),   json.at("wall_ms"),    json.at("cpu_ms")};
}

Json toJson(const DeviceRecord& record) { return {{"renderer", record.renderer}, {"version", record.version}}; }
DeviceRecord deviceFrom(const Json& json) { return {json.at("renderer"), json.at("version")}; }

std::string textOf(const Json& json, int indent) {
  return json.dump(indent, ' ', false, Json::error_handler_t::replace);
}

}  // namespace havs
