// Scene files: each key is one row of a table, and stands for the option of the command line that it sets.
#include "app/scene_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <sstream>
#include <variant>

#include "app/scene_forms.h"
#include "app/scene_views.h"
#include "core/error.h"
#include "core/nearest_name.h"
#include "core/text_file.h"
#include "transfer/json_text.h"

namespace havs {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kVersion = 1;

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
      {"max_memory", "--max-memory", &S::maxMemory},
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
  Json json = parseJson<Json>(readTextFile(file), file.string());
  if (!json.is_object()) failInput("a scene must be a JSON object", file.string());
  return json;
}

void change(Json& scene, const std::string& assignment) {
  const std::size_t equals = assignment.find('=');
  if (equals == std::string::npos || equals == 0)
    failInput("'" + assignment + "' is no change", "--set", "write key=value, such as k=4 or camera.azimuth=30");
  Json value = parsedOrDiscarded<Json>(std::string_view(assignment).substr(equals + 1));
  if (value.is_discarded()) value = assignment.substr(equals + 1);
  Json* at = &scene;
  std::istringstream path(assignment.substr(0, equals));
  int depth = 0;
  for (std::string part; std::getline(path, part, '.');) {
    if (++depth > kDeepestJson) failInput("a key of so many parts is none", "--set", "such as camera.azimuth");
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
  std::vector<std::string> names{kVersionKey, kOutputsKey, kViewsKey};
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
    if (name == kViewsKey) {
      options.views = readViews(value, file);
      continue;
    }
    const auto key =
        std::find_if(keys().begin(), keys().end(), [&name = name](const Key& k) { return k.name == name; });
    if (key == keys().end()) failInput("unknown key '" + name + "'", file.string(), didYouMean(name, knownKeys()));
    std::visit(Reader{options, *key, value, file}, key->member);
  }
  if (options.mesh.empty()) failInput("'mesh' is missing", file.string());
  if (!options.views.empty() && scene.contains(kOutputsKey))
    failInput("'outputs' belong to each of the 'views' here", file.string());
}

std::string sceneFileOf(const SceneOptions& options, std::span<const std::filesystem::path> outputs,
                        const std::filesystem::path& file) {
  Json scene{{kVersionKey, kVersion}};
  for (const Key& key : keys())
    if (auto value = std::visit(Writer{options, key, file.parent_path()}, key.member)) scene[key.name] = *value;
  if (!options.views.empty()) {
    scene[kViewsKey] = viewsAsJson(options.views, file.parent_path());
    return scene.dump(2) + "\n";
  }
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
  properties[kViewsKey] = viewsSchema();
  const Json schema{{"$schema", "https://json-schema.org/draft/2020-12/schema"},
                    {"title", "A scene of havs"},
                    {"type", "object"},
                    {"required", {kVersionKey, "mesh"}},
                    {"additionalProperties", false},
                    {"properties", properties}};
  return schema.dump(2) + "\n";
}

}  // namespace havs
