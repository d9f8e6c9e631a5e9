// Scene files: each key is one row of a table, and stands for the option of the command line that it sets.
#include "app/scene_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <variant>

#include "app/color_form.h"
#include "app/isosurface_options.h"
#include "app/overlay_options.h"
#include "core/error.h"
#include "core/nearest_name.h"
#include "transfer/json_text.h"
#include "transfer/transfer_function.h"

namespace havs {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kVersion = 1;
constexpr const char* kNone = "none";  ///< null in the file

/// How the value of a text option is written in the file.
struct Form {
  const char* needed;  ///< for messages
  Json schema;
  /// As the command line has it; empty where the value is of another kind. `folder`: the scene file's.
  std::optional<std::string> (*toText)(const Json& value, const std::filesystem::path& folder);
  Json (*fromText)(const std::string& text, const std::filesystem::path& folder);
};

using Folder = std::filesystem::path;

std::optional<std::string> numbersToText(const Json& value, std::size_t count, char separator) {
  if (!value.is_array() || value.size() != count) return std::nullopt;
  std::string text;
  for (const Json& part : value) {
    if (!part.is_number()) return std::nullopt;
    text += (text.empty() ? "" : std::string(1, separator)) + part.dump();
  }
  return text;
}

/// The text itself where it is not that many numbers: what is wrong with it is said when it is read.
Json numbersFromText(const std::string& text, std::size_t count, char separator) {
  Json numbers = Json::array();
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, separator);) {
    Json number = Json::parse(part, nullptr, false);
    if (!number.is_number()) return text;
    numbers.push_back(std::move(number));
  }
  return numbers.size() == count ? numbers : Json(text);
}

const Form kText{"a text",
                 {{"type", "string"}},
                 [](const Json& value, const Folder&) {
                   return value.is_string() ? std::optional(value.get<std::string>()) : std::nullopt;
                 },
                 [](const std::string& text, const Folder&) { return Json(text); }};

std::optional<std::string> fileToText(const Json& value, const Folder& folder) {
  if (!value.is_string()) return std::nullopt;
  return (folder / value.get<std::string>()).string();  // an absolute path stays
}
Json fileFromText(const std::string& text, const Folder& folder) {
  std::error_code none;
  const std::filesystem::path path = std::filesystem::relative(text, folder.empty() ? "." : folder, none);
  return none || path.empty() ? Json(text) : Json(path.string());
}
const Form kFile{"a path", {{"type", "string"}}, fileToText, fileFromText};

bool isPreset(const std::string& name) {
  const auto rows = transferPresets();
  return std::any_of(rows.begin(), rows.end(), [&](const auto& row) { return row.name == name; });
}
const Form kTransferFunction{"a preset's name or a path",
                             {{"type", "string"}},
                             [](const Json& value, const Folder& folder) {
                               const bool named = value.is_string() && isPreset(value.get<std::string>());
                               return named ? std::optional(value.get<std::string>()) : fileToText(value, folder);
                             },
                             [](const std::string& text, const Folder& folder) {
                               return isPreset(text) ? Json(text) : fileFromText(text, folder);
                             }};

Json listSchema(const char* type, int count) {
  return {{"type", "array"}, {"items", {{"type", type}}}, {"minItems", count}, {"maxItems", count}};
}
const Form kSize{"two whole numbers, as [1024, 768]", listSchema("integer", 2),
                 [](const Json& value, const Folder&) { return numbersToText(value, 2, 'x'); },
                 [](const std::string& text, const Folder&) { return numbersFromText(text, 2, 'x'); }};
const Form kRange{"two numbers, as [0, 1]", listSchema("number", 2),
                  [](const Json& value, const Folder&) { return numbersToText(value, 2, ','); },
                  [](const std::string& text, const Folder&) { return numbersFromText(text, 2, ','); }};
const Form kRangeOrNone{
    "two numbers, as [0, 1], or null for none",
    {{"anyOf", {listSchema("number", 2), {{"type", "null"}}}}},
    [](const Json& value, const Folder&) {
      return value.is_null() ? std::optional<std::string>(kNone) : numbersToText(value, 2, ',');
    },
    [](const std::string& text, const Folder&) { return text == kNone ? Json() : numbersFromText(text, 2, ','); }};

const Form kSixNumbers{"a list of six numbers, or a list of such lists", listSchema("number", 6),
                       [](const Json& value, const Folder&) { return numbersToText(value, 6, ','); },
                       [](const std::string& text, const Folder&) { return numbersFromText(text, 6, ','); }};

const Form kBackground{
    "a name, '#rrggbb', [r, g, b] from 0 to 1, {\"bottom\": ..., \"top\": ...} of two of these, or null "
    "for none",
    backgroundSchema(), [](const Json& value, const Folder&) { return backgroundToText(value); },
    [](const std::string& text, const Folder&) { return backgroundFromText(text); }};

const Form kCamera{"an object with azimuth, elevation and so on",
                   {{"type", {"object", "string"}}},
                   [](const Json& value, const Folder&) {
                     if (value.is_object()) return std::optional(value.dump());
                     return value.is_string() ? std::optional(value.get<std::string>()) : std::nullopt;
                   },
                   [](const std::string& text, const Folder&) {
                     Json object = Json::parse(text, nullptr, false);
                     std::ifstream file(text);  // or a file with it
                     if (object.is_discarded() && file) object = Json::parse(file, nullptr, false);
                     return object.is_object() ? object : Json(text);
                   }};

const Form kCountOrAuto{"a whole number, or \"auto\"",
                        {{"anyOf", {{{"type", "integer"}}, {{"const", "auto"}}}}},
                        [](const Json& value, const Folder&) {
                          if (value.is_number_integer()) return std::optional(value.dump());
                          return value == "auto" ? std::optional<std::string>("auto") : std::nullopt;
                        },
                        [](const std::string& text, const Folder&) {
                          const Json number = Json::parse(text, nullptr, false);
                          return number.is_number_integer() ? number : Json(text);
                        }};

/// "name=value,name=value"
std::optional<std::string> settingsToText(const Json& value, const Folder&) {
  if (value == "default") return "default";
  if (value.is_null()) return kNone;
  if (!value.is_object()) return std::nullopt;
  std::string text;
  for (const auto& [name, number] : value.items()) {
    if (!number.is_number()) return std::nullopt;
    text += (text.empty() ? "" : ",") + name + "=" + number.dump();
  }
  return text.empty() ? "default" : text;
}
Json settingsFromText(const std::string& text, const Folder&) {
  if (text == "default") return text;
  if (text == kNone) return {};
  Json object = Json::object();
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, ',');) {
    const std::size_t equals = part.find('=');
    if (equals == std::string::npos) return text;
    Json number = Json::parse(part.substr(equals + 1), nullptr, false);
    if (!number.is_number()) return text;
    object[part.substr(0, equals)] = std::move(number);
  }
  return object;
}
const Form kSettings{"\"default\", an object of numbers, or null for none",
                     {{"anyOf",
                       {{{"const", "default"}},
                        {{"type", "null"}},
                        {{"type", "object"}, {"additionalProperties", {{"type", "number"}}}}}}},
                     settingsToText,
                     settingsFromText};
const Form kIsosurface{
    "an object with a value, or a list of such, as {\"value\": 0.5, \"color\": \"red\", \"opacity\": 0.3}",
    isosurfaceSchema(), isosurfaceToText, isosurfaceFromText};

const Form kStyle{"\"default\", or an object such as {\"color\": \"red\", \"width\": 2}", styleSchema(), styleToText,
                  styleFromText};

using Text = std::optional<std::string> SceneOptions::*;
using Texts = std::vector<std::string> SceneOptions::*;
using Number = std::optional<double> SceneOptions::*;
using Count = std::optional<int> SceneOptions::*;
using Name = std::string SceneOptions::*;
using Flag = bool SceneOptions::*;

struct Key {
  const char* name;
  const char* option;  ///< of the command line, for the schema
  std::variant<Text, Texts, Number, Count, Name, Flag> member;
  const Form* form = &kText;  ///< of texts; of several, of each
};

const std::vector<Key>& keys() {
  using S = SceneOptions;
  static const std::vector<Key> rows{
      {"mesh", "INPUT", &S::mesh, &kFile},
      {"plot3d_solution", "--q", &S::plot3dSolution, &kFile},
      {"tetgen", "--tetgen", &S::tetgenSwitches},
      {"field", "--field", &S::field},
      {"transfer_function", "--tf", &S::transferFunction, &kTransferFunction},
      {"unit_length", "--unit-length", &S::unitLength},
      {"domain", "--domain", &S::domain, &kRange},
      {"isosurfaces", "--isosurface", &S::isosurfaces, &kIsosurface},
      {"outline", "--outline", &S::outline, &kStyle},
      {"surface", "--surface", &S::surface, &kStyle},
      {"wireframe", "--wireframe", &S::wireFrame, &kStyle},
      {"mode", "--mode", &S::mode},
      {"clip_plane", "--clip-plane", &S::clipPlanes, &kSixNumbers},
      {"clip_box", "--clip-box", &S::clipBoxes, &kSixNumbers},
      {"cut_box", "--cut-box", &S::cutBoxes, &kSixNumbers},
      {"threshold", "--threshold", &S::threshold, &kRangeOrNone},
      {"lighting", "--lighting", &S::lighting, &kSettings},
      {"light", "--light", &S::lights},
      {"shadows", "--shadows", &S::shadows},
      {"occlusion", "--occlusion", &S::occlusion, &kSettings},
      {"scattering", "--scattering", &S::scattering, &kSettings},
      {"modulation", "--modulation", &S::modulation},
      {"size", "--size", &S::size, &kSize},
      {"camera", "--camera", &S::camera, &kCamera},
      {"projection", "--projection", &S::projection},
      {"background", "--background", &S::background, &kBackground},
      {"device", "--device", &S::device},
      {"simd", "--simd", &S::instructionSet},
      {"visibility", "--visibility", &S::visibility},
      {"k", "--k", &S::k, &kCountOrAuto},
      {"sort", "--sort", &S::sort},
      {"lookup", "--lookup", &S::lookup},
      {"table", "--table", &S::tableSize},
      {"table_format", "--table-format", &S::tableFormat},
      {"target_format", "--target-format", &S::targetFormat},
      {"early_termination", "--early-termination", &S::earlyTermination},
      {"composite_late", "--composite-late", &S::compositeLate},
      {"paper", "--paper", &S::paper},
      {"threads", "--threads", &S::threads},
      {"repeat", "--repeat", &S::repeat},
  };
  return rows;
}

constexpr const char* kVersionKey = "version";
constexpr const char* kOutputsKey = "outputs";

[[noreturn]] void failValue(const Key& key, const std::string& needed, const std::string& file) {
  failInput(fmt::format("'{}' must be {}", key.name, needed), file);
}

/// Sets one member where the command line has left it unset.
struct Reader {
  SceneOptions& options;
  const Key& key;
  const Json& value;
  const std::filesystem::path& file;

  std::string text() const {
    const auto text = key.form->toText(value, file.parent_path());
    if (!text) failValue(key, key.form->needed, file.string());
    return *text;
  }
  void operator()(Text member) const {
    const std::string read = text();
    if (!(options.*member)) options.*member = read;
  }
  /// A list of values, or one value.
  void operator()(Texts member) const {
    std::vector<std::string> texts;
    const bool several = value.is_array() && std::all_of(value.begin(), value.end(), [](const Json& one) {
                           return one.is_structured() || one.is_string();
                         });
    for (const Json& one : several ? value : Json::array({value}))
      texts.push_back(Reader{options, key, one, file}.text());
    if ((options.*member).empty()) options.*member = texts;
  }
  void operator()(Name member) const {
    const std::string read = text();
    if ((options.*member).empty()) options.*member = read;
  }
  void operator()(Number member) const {
    if (!value.is_number()) failValue(key, "a number", file.string());
    if (!(options.*member)) options.*member = value.get<double>();
  }
  void operator()(Count member) const {
    if (!value.is_number_integer()) failValue(key, "a whole number", file.string());
    const auto number = value.get<std::int64_t>();
    if (number < INT32_MIN || number > INT32_MAX) failValue(key, "a smaller number", file.string());
    if (!(options.*member)) options.*member = static_cast<int>(number);
  }
  void operator()(Flag member) const {
    if (!value.is_boolean()) failValue(key, "true or false", file.string());
    options.*member = options.*member || value.get<bool>();
  }
};

/// The value of a member as the file has it; null where it is unset.
struct Writer {
  const SceneOptions& options;
  const Key& key;
  const std::filesystem::path folder;

  std::optional<Json> operator()(Text member) const {
    return options.*member ? std::optional(key.form->fromText(*(options.*member), folder)) : std::nullopt;
  }
  std::optional<Json> operator()(Texts member) const {
    Json list = Json::array();
    for (const std::string& text : options.*member) list.push_back(key.form->fromText(text, folder));
    return list.empty() ? std::nullopt : std::optional(list);
  }
  std::optional<Json> operator()(Name member) const {
    return (options.*member).empty() ? std::nullopt : std::optional(key.form->fromText(options.*member, folder));
  }
  std::optional<Json> operator()(Number member) const {
    return options.*member ? std::optional<Json>(*(options.*member)) : std::nullopt;
  }
  std::optional<Json> operator()(Count member) const {
    return options.*member ? std::optional<Json>(*(options.*member)) : std::nullopt;
  }
  std::optional<Json> operator()(Flag member) const {
    return options.*member ? std::optional<Json>(true) : std::nullopt;
  }
};

struct SchemaOf {
  const Key& key;
  Json operator()(Text) const { return key.form->schema; }
  Json operator()(Texts) const {
    return {{"anyOf", {key.form->schema, {{"type", "array"}, {"items", key.form->schema}}}}};
  }
  Json operator()(Name) const { return key.form->schema; }
  Json operator()(Number) const { return {{"type", "number"}}; }
  Json operator()(Count) const { return {{"type", "integer"}}; }
  Json operator()(Flag) const { return {{"type", "boolean"}}; }
};

Json contentOf(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::stringstream text;
  text << stream.rdbuf();
  if (!stream) failInput("cannot be read", file.string(), "is there such a file?");
  Json json = parseJson<Json>(text.str(), file.string());
  if (!json.is_object()) failInput("a scene must be a JSON object", file.string());
  return json;
}

void change(Json& scene, const std::string& assignment) {
  const std::size_t equals = assignment.find('=');
  if (equals == std::string::npos || equals == 0)
    failInput("'" + assignment + "' is no change", "--set", "write key=value, such as k=4 or camera.azimuth=30");
  Json value = Json::parse(assignment.substr(equals + 1), nullptr, false);
  if (value.is_discarded()) value = assignment.substr(equals + 1);
  Json* at = &scene;
  std::istringstream path(assignment.substr(0, equals));
  for (std::string part; std::getline(path, part, '.');) {
    if (!at->is_object() && !at->is_null())
      failInput("'" + assignment + "' changes a part of what has none", "--set", "set the whole of it");
    at = &(*at)[part];
  }
  *at = std::move(value);
}

void readOutputs(const Json& value, const std::string& file, std::vector<std::filesystem::path>& outputs) {
  const bool isList =
      value.is_array() && std::all_of(value.begin(), value.end(), [](const Json& one) { return one.is_string(); });
  if (!isList) failInput("'outputs' must be a list of paths", file);
  if (!outputs.empty()) return;
  for (const Json& one : value) outputs.emplace_back(one.get<std::string>());
}

std::vector<std::string> knownKeys() {
  std::vector<std::string> names{kVersionKey, kOutputsKey};
  for (const Key& key : keys()) names.emplace_back(key.name);
  return names;
}

}  // namespace

bool isSceneFile(const std::string& input) { return std::filesystem::path(input).extension() == ".json"; }

void readSceneFile(SceneOptions& options, std::vector<std::filesystem::path>& outputs,
                   std::span<const std::string> changes) {
  const std::filesystem::path file = options.mesh;
  options.mesh.clear();
  Json scene = contentOf(file);
  for (const std::string& assignment : changes) change(scene, assignment);
  if (!scene.contains(kVersionKey) || scene[kVersionKey] != kVersion)
    failInput(fmt::format("'{}' must be {}", kVersionKey, kVersion), file.string(),
              "is it a scene file? Other JSON goes with --tf or --camera");
  for (const auto& [name, value] : scene.items()) {
    if (name == kVersionKey) continue;
    if (name == kOutputsKey) {
      readOutputs(value, file.string(), outputs);
      continue;
    }
    const auto key =
        std::find_if(keys().begin(), keys().end(), [&name = name](const Key& k) { return k.name == name; });
    if (key == keys().end()) failInput("unknown key '" + name + "'", file.string(), didYouMean(name, knownKeys()));
    std::visit(Reader{options, *key, value, file}, key->member);
  }
  if (options.mesh.empty()) failInput("'mesh' is missing", file.string());
}

std::string sceneFileOf(const SceneOptions& options, std::span<const std::filesystem::path> outputs,
                        const std::filesystem::path& file) {
  Json scene{{kVersionKey, kVersion}};
  for (const Key& key : keys())
    if (auto value = std::visit(Writer{options, key, file.parent_path()}, key.member)) scene[key.name] = *value;
  if (!outputs.empty()) scene[kOutputsKey] = Json::array();
  for (const auto& output : outputs) scene[kOutputsKey].push_back(output.string());
  return scene.dump(2) + "\n";
}

std::string sceneFileSchema() {
  Json properties{{kVersionKey, {{"const", kVersion}}}};
  for (const Key& key : keys()) {
    properties[key.name] = std::visit(SchemaOf{key}, key.member);
    properties[key.name]["description"] = fmt::format("as the option {} of havs render", key.option);
  }
  properties[kOutputsKey] = {{"type", "array"},
                             {"items", {{"type", "string"}}},
                             {"description", "pictures to write, as --output; relative to where havs runs"}};
  const Json schema{{"$schema", "https://json-schema.org/draft/2020-12/schema"},
                    {"title", "A scene of havs"},
                    {"type", "object"},
                    {"required", {kVersionKey, "mesh"}},
                    {"additionalProperties", false},
                    {"properties", properties}};
  return schema.dump(2) + "\n";
}

}  // namespace havs
