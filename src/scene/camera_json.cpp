// The camera as text: "azimuth,elevation[,zoom]" or a JSON object.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <numbers>
#include <sstream>

#include "core/error.h"
#include "core/nearest_name.h"
#include "core/text_file.h"
#include "scene/camera.h"
#include "transfer/json_text.h"

namespace havs {
namespace {

using Json = nlohmann::ordered_json;

[[noreturn]] void failValue(const std::string& key, const std::string& needed) {
  failInput("'" + key + "' must be " + needed, "camera");
}

double number(const std::string& key, const Json& value) {
  if (!value.is_number()) failValue(key, "a number");
  return value.get<double>();
}

Vec3 vector(const std::string& key, const Json& value) {
  if (!value.is_array() || value.size() != 3) failValue(key, "three numbers");
  return {number(key, value[0]), number(key, value[1]), number(key, value[2])};
}

Projection projection(const std::string& key, const Json& value) {
  if (value == "perspective") return Projection::perspective;
  if (value == "orthographic") return Projection::orthographic;
  failValue(key, "\"perspective\" or \"orthographic\"");
}

using Setter = std::function<void(Camera&, const std::string&, const Json&)>;

/// The keys of a camera: a new one is one row.
const std::map<std::string, Setter>& setters() {
  static const std::map<std::string, Setter> table{
      {"projection", [](Camera& c, auto& key, auto& v) { c.projection = projection(key, v); }},
      {"azimuth", [](Camera& c, auto& key, auto& v) { c.azimuth = number(key, v); }},
      {"elevation", [](Camera& c, auto& key, auto& v) { c.elevation = number(key, v); }},
      {"zoom", [](Camera& c, auto& key, auto& v) { c.zoom = number(key, v); }},
      {"field_of_view", [](Camera& c, auto& key, auto& v) { c.fieldOfView = number(key, v); }},
      {"eye", [](Camera& c, auto& key, auto& v) { c.eye = vector(key, v); }},
      {"target", [](Camera& c, auto& key, auto& v) { c.target = vector(key, v); }},
      {"up", [](Camera& c, auto& key, auto& v) { c.up = vector(key, v); }},
      {"view_height", [](Camera& c, auto& key, auto& v) { c.viewHeight = number(key, v); }},
  };
  return table;
}

Camera fromJson(const std::string& text, Projection defaultProjection) {
  Camera camera;
  camera.projection = defaultProjection;
  const Json json = parsedOrDiscarded<Json>(text);
  if (!json.is_object()) failInput("not a JSON object", "camera", R"(for example {"azimuth": 30, "elevation": 20})");
  for (const auto& [key, value] : json.items()) {
    const auto setter = setters().find(key);
    if (setter == setters().end()) {
      std::vector<std::string> known;
      for (const auto& row : setters()) known.push_back(row.first);
      failInput("unknown key '" + key + "'", "camera", didYouMean(key, known));
    }
    setter->second(camera, key, value);
  }
  return camera;
}

Camera fromAngles(const std::string& text, Projection projection) {
  Camera camera;
  camera.projection = projection;
  double* const parts[] = {&camera.azimuth, &camera.elevation, &camera.zoom};
  const auto count = static_cast<std::size_t>(std::count(text.begin(), text.end(), ',') + 1);
  std::istringstream stream(text);
  std::string part;
  bool good = count == 2 || count == 3;
  for (std::size_t i = 0; good && i < count; ++i) {
    std::istringstream number(std::getline(stream, part, ',') ? part : "");
    good = number >> *parts[i] && (number >> std::ws).eof();
  }
  if (!good)
    failInput("cannot read '" + text + "'", "camera", "give azimuth,elevation[,zoom] in degrees, JSON, or a JSON file");
  return camera;
}

Json asJson(const Vec3& v) { return Json::array({v.x, v.y, v.z}); }

}  // namespace

Camera parseCamera(const std::string& text, Projection projection) {
  const auto begin = text.find_first_not_of(" \t\r\n");
  if (begin != std::string::npos && text[begin] == '{') return fromJson(text, projection);
  std::error_code ignored;
  if (std::filesystem::is_regular_file(text, ignored)) {
    return fromJson(readTextFile(text), projection);
  }
  return fromAngles(text, projection);
}

std::string describe(const Camera& camera, const LocalFrame& frame, int width, int height) {
  const View view = makeView(camera, frame, width, height);
  auto toWorld = [&](const Vec3& local) { return frame.center + frame.radius * local; };
  Json json;
  json["projection"] = view.orthographic ? "orthographic" : "perspective";
  json["eye"] = asJson(toWorld(view.eye));
  json["target"] = asJson(camera.target.value_or(frame.center));
  json["up"] = asJson(view.up);
  if (view.orthographic)
    json["view_height"] = 2.0 * view.halfHeight * frame.radius;
  else
    json["field_of_view"] = 2.0 * std::atan(view.halfHeight) * 180.0 / std::numbers::pi;
  return json.dump();
}

}  // namespace havs
