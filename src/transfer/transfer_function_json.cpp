#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <vector>

#include "core/error.h"
#include "core/nearest_name.h"
#include "transfer/json_text.h"
#include "transfer/transfer_files.h"

namespace havs {
namespace {

using Json = nlohmann::ordered_json;

const std::vector<std::string> kKeys{"version", "name", "opacity", "unit_length", "domain", "scale", "points"};
const std::vector<std::string> kPointKeys{"scalar", "color", "opacity"};
const std::vector<std::string> kMeanings{"per_unit", "extinction"};
const std::vector<std::string> kScales{"normalised", "data"};

void checkKeys(const Json& object, const std::vector<std::string>& known, const std::string& where) {
  for (const auto& [key, value] : object.items()) {
    if (std::find(known.begin(), known.end(), key) == known.end()) {
      failInput(fmt::format("unknown key '{}'", key), where, didYouMean(key, known));
    }
  }
}

double number(const Json& value, const std::string& what, const std::string& where) {
  if (!value.is_number()) failInput(fmt::format("{} is no number", what), where);
  return value.get<double>();
}

/// True for the second name of two, false for the first.
bool isSecond(const Json& value, const std::vector<std::string>& names, const std::string& key,
              const std::string& where) {
  const std::string name = value.is_string() ? value.get<std::string>() : quoted(value);
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (name == names[i]) return i == 1;
  }
  failInput(fmt::format("'{}' cannot be '{}'", key, name), where, didYouMean(name, names));
}

ControlPoint readPoint(const Json& value, const std::string& where) {
  if (!value.is_object())
    failInput("a point is no object", where, R"(write {"scalar": 0.5, "color": [1, 0, 0], "opacity": 0.1})");
  checkKeys(value, kPointKeys, where);
  for (const std::string& key : kPointKeys) {
    if (!value.contains(key)) failInput(fmt::format("'{}' is missing", key), where);
  }
  ControlPoint point;
  point.scalar = number(value["scalar"], "'scalar'", where);
  point.opacity = number(value["opacity"], "'opacity'", where);
  const Json& color = value["color"];
  if (!color.is_array() || color.size() != 3) failInput("'color' is no list of three numbers", where);
  for (std::size_t i = 0; i < 3; ++i) point.color[i] = number(color[i], "'color'", where);
  return point;
}

std::array<double, 2> readDomain(const Json& value, const std::string& where) {
  if (!value.is_array() || value.size() != 2) failInput("'domain' is no list of two numbers", where);
  return {number(value[0], "'domain'", where), number(value[1], "'domain'", where)};
}

}  // namespace

TransferFunction readTransferJson(std::string_view text, const std::string& file) {
  const Json json = parseJson<Json>(text, file);
  if (!json.is_object()) failInput("a transfer function is a JSON object", file);
  checkKeys(json, kKeys, file);
  if (!json.contains("version")) failInput("'version' is missing", file, R"(write "version": 1)");
  if (json["version"] != 1)
    failInput(fmt::format("version {} is not known", quoted(json["version"])), file, "this program reads version 1");
  if (!json.contains("points") || !json["points"].is_array() || json["points"].empty()) {
    failInput("'points' is no list of at least one control point", file);
  }
  TransferFunction function;
  if (json.contains("name")) {
    if (!json["name"].is_string()) failInput("'name' is no text", file);
    function.name = json["name"].get<std::string>();
  }
  if (json.contains("opacity") && isSecond(json["opacity"], kMeanings, "opacity", file))
    function.meaning = OpacityMeaning::extinction;
  if (json.contains("scale")) function.normalised = !isSecond(json["scale"], kScales, "scale", file);
  if (json.contains("unit_length") && !json["unit_length"].is_null())
    function.unitLength = number(json["unit_length"], "'unit_length'", file);
  if (json.contains("domain") && !json["domain"].is_null()) function.domain = readDomain(json["domain"], file);
  for (const Json& point : json["points"]) {
    function.points.push_back(readPoint(point, fmt::format("{}, point {}", file, function.points.size() + 1)));
  }
  checkTransferFunction(function, file);
  return function;
}

std::string toJson(const TransferFunction& function) {
  Json json;
  json["version"] = 1;
  json["name"] = function.name;
  json["opacity"] = kMeanings[function.meaning == OpacityMeaning::extinction];
  json["unit_length"] = function.unitLength ? Json(*function.unitLength) : Json(nullptr);
  json["domain"] = function.domain ? Json(*function.domain) : Json(nullptr);
  json["scale"] = kScales[!function.normalised];
  json["points"] = Json::array();
  for (const ControlPoint& p : function.points) {
    json["points"].push_back({{"scalar", p.scalar}, {"color", p.color}, {"opacity", p.opacity}});
  }
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace havs
