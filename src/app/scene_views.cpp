#include "app/scene_views.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/scene_forms.h"
#include "core/error.h"
#include "core/nearest_name.h"

namespace havs {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kOutputs = "outputs";

struct ViewKey {
  const char* name;
  std::optional<std::string> ViewOptions::*member;
  const Form& form;
};
const std::vector<ViewKey>& viewKeys() {
  static const std::vector<ViewKey> rows{{"camera", &ViewOptions::camera, kCamera},
                                         {"projection", &ViewOptions::projection, kText}};
  return rows;
}

[[noreturn]] void failView(std::size_t number, const std::string& what, const std::filesystem::path& file,
                           const std::string& hint = "") {
  failInput(fmt::format("view {}: {}", number, what), file.string(), hint);
}

void readKey(ViewOptions& view, const std::string& name, const Json& value, std::size_t number,
             const std::filesystem::path& file) {
  if (name == kOutputs) {
    const bool texts =
        value.is_array() && std::all_of(value.begin(), value.end(), [](const Json& one) { return one.is_string(); });
    if (!texts) failView(number, "'outputs' must be a list of paths", file);
    for (const Json& one : value) view.outputs.emplace_back(one.get<std::string>());
    return;
  }
  std::vector<std::string> known{kOutputs};
  for (const ViewKey& key : viewKeys()) {
    known.emplace_back(key.name);
    if (name != key.name) continue;
    view.*key.member = key.form.toText(value, file.parent_path());
    if (!(view.*key.member)) failView(number, fmt::format("'{}' must be {}", name, key.form.needed), file);
    return;
  }
  failView(number, "unknown key '" + name + "'", file, didYouMean(name, known));
}

}  // namespace

std::vector<ViewOptions> readViews(const Json& list, const std::filesystem::path& file) {
  std::vector<ViewOptions> views;
  if (list.is_null()) return views;
  if (!list.is_array()) failInput(fmt::format("'{}' must be a list of objects, or null", kViewsKey), file.string());
  for (const Json& one : list) {
    ViewOptions& view = views.emplace_back();
    if (!one.is_object()) failView(views.size(), "must be an object", file);
    for (const auto& [name, value] : one.items()) readKey(view, name, value, views.size(), file);
  }
  for (std::size_t i = 0; i < views.size(); ++i)
    if (views[i].outputs.empty()) failView(i + 1, "'outputs' is missing: no picture would be kept of it", file);
  return views;
}

Json viewsAsJson(const std::vector<ViewOptions>& views, const std::filesystem::path& folder) {
  Json list = Json::array();
  for (const ViewOptions& view : views) {
    Json one = Json::object();
    for (const ViewKey& key : viewKeys())
      if (view.*key.member) one[key.name] = key.form.fromText(*(view.*key.member), folder);
    for (const auto& output : view.outputs) one[kOutputs].push_back(output.string());
    list.push_back(std::move(one));
  }
  return list;
}

Json viewsSchema() {
  Json properties = Json::object();
  for (const ViewKey& key : viewKeys()) properties[key.name] = key.form.schema;
  properties[kOutputs] = {{"type", "array"}, {"items", {{"type", "string"}}}, {"minItems", 1}};
  const Json view{
      {"type", "object"}, {"required", {kOutputs}}, {"additionalProperties", false}, {"properties", properties}};
  return {{"type", {"array", "null"}},
          {"items", view},
          {"description", "several cameras, each with its pictures; the mesh is read once"}};
}

std::vector<SceneOptions> optionsOfViews(const SceneOptions& options) {
  std::vector<SceneOptions> all;
  SceneOptions shared = options;
  shared.views = {};  // before it is copied for each of them
  for (const ViewOptions& view : options.views) {
    SceneOptions& one = all.emplace_back(shared);
    if (view.camera) one.camera = view.camera;
    if (view.projection) one.projection = view.projection;
  }
  if (all.empty()) all.push_back(options);
  return all;
}

void refuseViews(const SceneOptions& options, const char* option) {
  if (options.views.size() > 1)
    failInput(fmt::format("is for one picture, and the scene has {} views", options.views.size()), option,
              fmt::format("leave the others out, or all with --set {}=null", kViewsKey));
}

}  // namespace havs
