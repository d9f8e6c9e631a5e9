#include "app/color_form.h"

#include <sstream>

namespace havs {
namespace {

using Json = nlohmann::ordered_json;

}  // namespace

std::optional<std::string> colorToText(const Json& value) {
  if (value.is_string()) return value.get<std::string>();
  if (!value.is_array() || value.size() != 3) return std::nullopt;
  std::string text;
  for (const Json& part : value) {
    if (!part.is_number()) return std::nullopt;
    text += (text.empty() ? "" : ",") + part.dump();
  }
  return text;
}

Json colorFromText(const std::string& text) {
  Json numbers = Json::array();
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, ',');) {
    Json number = Json::parse(part, nullptr, false);
    if (!number.is_number()) return text;
    numbers.push_back(std::move(number));
  }
  return numbers.size() == 3 ? numbers : Json(text);
}

Json colorSchema() {
  const Json numbers{{"type", "array"}, {"items", {{"type", "number"}}}, {"minItems", 3}, {"maxItems", 3}};
  return {{"anyOf", {{{"type", "string"}}, numbers}}};
}

std::optional<std::string> backgroundToText(const Json& value) {
  if (value.is_null()) return "none";
  if (!value.is_object()) return colorToText(value);
  if (value.size() != 2 || !value.contains("bottom") || !value.contains("top")) return std::nullopt;
  const auto bottom = colorToText(value["bottom"]), top = colorToText(value["top"]);
  if (!bottom || !top) return std::nullopt;
  return *bottom + ".." + *top;
}

Json backgroundFromText(const std::string& text) {
  if (text == "none") return nullptr;
  const std::size_t between = text.find("..");
  if (between == std::string::npos) return colorFromText(text);
  return {{"bottom", colorFromText(text.substr(0, between))}, {"top", colorFromText(text.substr(between + 2))}};
}

Json backgroundSchema() {
  const Json gradient{{"type", "object"},
                      {"properties", {{"bottom", colorSchema()}, {"top", colorSchema()}}},
                      {"required", {"bottom", "top"}},
                      {"additionalProperties", false}};
  return {{"anyOf", {colorSchema(), {{"type", "null"}}, gradient}}};
}

}  // namespace havs
