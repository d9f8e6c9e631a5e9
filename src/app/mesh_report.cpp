#include "app/mesh_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/error.h"

namespace havs {
namespace {

using Json = nlohmann::ordered_json;

std::string nameOf(Centering centering) { return centering == Centering::point ? "point" : "cell"; }

std::vector<bool> pointsInUse(const TetMesh& mesh) {
  std::vector<bool> used(mesh.points.size());
  for (const Tetrahedron& cell : mesh.tetrahedra)
    for (const Index point : cell) used[point] = true;
  return used;
}

FieldSummary summarise(const Field& field, Centering centering, const std::vector<bool>& used) {
  FieldSummary summary{field.name, centering, field.components, std::nullopt};
  for (std::size_t i = 0; i < field.tuples(); ++i) {
    const double value = field.components == 1 ? field.values[i] : magnitudeAt(field, i);
    if ((centering == Centering::point && !used[i]) || !std::isfinite(value)) continue;
    if (!summary.range) summary.range = Range{value, value};
    summary.range->minimum = std::min(summary.range->minimum, value);
    summary.range->maximum = std::max(summary.range->maximum, value);
  }
  return summary;
}

/// A mesh without a field that could be drawn is still worth a report; a field that is asked for must be there.
std::optional<ScalarField> fieldToDraw(const TetMesh& mesh, const std::string& name) {
  try {
    return selectField(mesh, name);
  } catch (const Error&) {
    if (!name.empty()) throw;
    return std::nullopt;
  }
}

Json rangeAsJson(const Range& range) { return {range.minimum, range.maximum}; }
Json pointAsJson(const Vec3& p) { return {p.x, p.y, p.z}; }
std::string rangeAsText(const Range& range) { return fmt::format("{:.6g} to {:.6g}", range.minimum, range.maximum); }

}  // namespace

MeshReport reportMesh(const TetMesh& mesh, const std::filesystem::path& file, const std::string& field) {
  MeshReport report;
  report.file = file;
  report.points = mesh.points.size();
  report.cells = mesh.sourceCells;
  report.tetrahedra = mesh.tetrahedra.size();
  const auto used = pointsInUse(mesh);
  for (const Field& f : mesh.pointFields) report.fields.push_back(summarise(f, Centering::point, used));
  for (const Field& f : mesh.cellFields) report.fields.push_back(summarise(f, Centering::cell, used));
  report.drawn = fieldToDraw(mesh, field);
  report.quality = measureQuality(mesh);
  report.defects = inspectMesh(mesh);
  report.notes = mesh.notes;
  return report;
}

Json defectsAsJson(const std::vector<Defect>& defects) {
  Json json = Json::array();
  for (const Defect& defect : defects) {
    Json row{{"name", defect.name}, {"count", defect.count}};
    row["first"] = defect.count > 0 ? Json(defect.first) : Json();
    row["repair"] = defect.repair;
    json.push_back(row);
  }
  return json;
}

Json reportAsJson(const MeshReport& report) {
  Json json{{"file", report.file.string()},
            {"points", report.points},
            {"cells", report.cells},
            {"tetrahedra", report.tetrahedra}};
  json["bounds"] = {pointAsJson(report.quality.bounds[0]), pointAsJson(report.quality.bounds[1])};
  json["fields"] = Json::array();
  for (const FieldSummary& field : report.fields)
    json["fields"].push_back({{"name", field.name},
                              {"centering", nameOf(field.centering)},
                              {"components", field.components},
                              {"range", field.range ? rangeAsJson(*field.range) : Json()}});
  json["field"] = Json();
  if (report.drawn)
    json["field"] = {{"name", report.drawn->name},
                     {"centering", nameOf(report.drawn->centering)},
                     {"range", {report.drawn->minimum, report.drawn->maximum}}};
  json["quality"] = {{"edge_length", rangeAsJson(report.quality.edgeLength)},
                     {"volume", rangeAsJson(report.quality.volume)},
                     {"aspect_ratio", rangeAsJson(report.quality.aspectRatio)},
                     {"median_aspect_ratio", report.quality.medianAspectRatio}};
  json["defects"] = defectsAsJson(report.defects);
  json["notes"] = report.notes;
  return json;
}

std::string reportAsText(const MeshReport& report) {
  std::string text;
  auto line = [&](const char* label, const std::string& content) { text += fmt::format("{:<12}{}\n", label, content); };
  const auto& [low, high] = report.quality.bounds;
  line("file", report.file.string());
  line("points", fmt::format("{}", report.points));
  line("cells", fmt::format("{}", report.cells));
  line("tetrahedra", fmt::format("{}", report.tetrahedra));
  line("bounds", fmt::format("x {}, y {}, z {}", rangeAsText({low.x, high.x}), rangeAsText({low.y, high.y}),
                             rangeAsText({low.z, high.z})));
  line("edges", rangeAsText(report.quality.edgeLength));
  line("volumes", rangeAsText(report.quality.volume));
  line("aspect", fmt::format("{}, median {:.6g} (1: regular)", rangeAsText(report.quality.aspectRatio),
                             report.quality.medianAspectRatio));
  for (const FieldSummary& field : report.fields)
    line("field",
         fmt::format("{}: {} data, {} component{}, {}", field.name, nameOf(field.centering), field.components,
                     field.components == 1 ? "" : "s", field.range ? rangeAsText(*field.range) : "no finite value"));
  line("drawn", report.drawn ? fmt::format("{} ({} data), {}", report.drawn->name, nameOf(report.drawn->centering),
                                           rangeAsText({report.drawn->minimum, report.drawn->maximum}))
                             : "no field; havs mesh --scalar adds one");
  const bool sound =
      std::all_of(report.defects.begin(), report.defects.end(), [](const Defect& d) { return d.count == 0; });
  if (sound) line("defects", "none");
  for (const Defect& defect : report.defects)
    if (defect.count > 0) line("defect", describe(defect));
  for (const std::string& note : report.notes) line("note", note);
  return text;
}

}  // namespace havs
