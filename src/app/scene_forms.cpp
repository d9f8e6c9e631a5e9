#include "app/scene_forms.h"

#include <algorithm>
#include <sstream>

#include "app/color_form.h"
#include "app/isosurface_options.h"
#include "app/overlay_options.h"
#include "core/text_file.h"
#include "transfer/json_text.h"
#include "transfer/transfer_function.h"

namespace havs {
namespace {

using Json = Form::Json;

constexpr const char* kNone = "none";  ///< null in the file

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

std::optional<std::string> fileToText(const Json& value, const Folder& folder) {
  if (!value.is_string()) return std::nullopt;
  return (folder / value.get<std::string>()).string();  // an absolute path stays
}
Json fileFromText(const std::string& text, const Folder& folder) {
  std::error_code none;
  const std::filesystem::path path = std::filesystem::relative(text, folder.empty() ? "." : folder, none);
  return none || path.empty() ? Json(text) : Json(path.string());
}
bool isPreset(const std::string& name) {
  const auto rows = transferPresets();
  return std::any_of(rows.begin(), rows.end(), [&](const auto& row) { return row.name == name; });
}
Json listSchema(const char* type, int count) {
  return {{"type", "array"}, {"items", {{"type", type}}}, {"minItems", count}, {"maxItems", count}};
}
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

}  // namespace

const Form kText{"a text",
                 {{"type", "string"}},
                 [](const Json& value, const Folder&) {
                   return value.is_string() ? std::optional(value.get<std::string>()) : std::nullopt;
                 },
                 [](const std::string& text, const Folder&) { return Json(text); }};

const Form kFile{"a path", {{"type", "string"}}, fileToText, fileFromText};

const Form kTransferFunction{"a preset's name or a path",
                             {{"type", "string"}},
                             [](const Json& value, const Folder& folder) {
                               const bool named = value.is_string() && isPreset(value.get<std::string>());
                               return named ? std::optional(value.get<std::string>()) : fileToText(value, folder);
                             },
                             [](const std::string& text, const Folder& folder) {
                               return isPreset(text) ? Json(text) : fileFromText(text, folder);
                             }};

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
                     Json object = parsedOrDiscarded<Json>(text);
                     std::error_code none;  // or a file with it
                     if (object.is_discarded() && std::filesystem::is_regular_file(text, none))
                       object = parsedOrDiscarded<Json>(readTextFile(text));
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

}  // namespace havs
