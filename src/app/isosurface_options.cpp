#include "app/isosurface_options.h"

#include <fmt/format.h>

#include <charconv>

#include "app/color_form.h"
#include "core/error.h"
#include "core/nearest_name.h"
#include "image/color_names.h"

namespace havs {
namespace {

using Json = nlohmann::ordered_json;

const std::vector<std::string> kKeys{"value", "color", "opacity"};
constexpr const char* kOption = "--isosurface";
constexpr const char* kForm = "write VALUE[,COLOR[,OPACITY]], such as 0.5, 0.5,red, 0.5,'#ff8000',0.3 or 0.5,,0.3";

/// VALUE, COLOR, OPACITY as typed; what is left out is empty.
struct Parts {
  std::string value, color, opacity;
};

/// A colour of three numbers has commas of its own.
Parts partsOf(const std::string& text) {
  std::vector<std::string> fields(1);
  for (const char c : text) {
    if (c == ',')
      fields.emplace_back();
    else
      fields.back() += c;
  }
  if (fields.size() > 5) failInput(fmt::format("'{}' is no isosurface", text), kOption, kForm);
  Parts parts{fields[0], "", ""};
  const bool numbers = fields.size() > 3;
  if (fields.size() > 1) parts.color = numbers ? fields[1] + "," + fields[2] + "," + fields[3] : fields[1];
  const std::size_t last = numbers ? 4 : 2;
  if (fields.size() > last) {
    parts.opacity = fields[last];
    if (parts.opacity.empty())
      failInput(fmt::format("'{}' has no opacity behind its last comma", text), kOption, kForm);
  }
  return parts;
}

double numberOf(const std::string& text, const char* what) {
  double number = 0;
  const char* const end = text.data() + text.size();
  const auto [last, error] = std::from_chars(text.data(), end, number);
  if (error != std::errc{} || last != end)
    failInput(fmt::format("'{}' is no {} of an isosurface", text, what), kOption, kForm);
  return number;
}

Isosurface isosurfaceOf(const std::string& text) {
  const Parts parts = partsOf(text);
  Isosurface surface;
  surface.value = numberOf(parts.value, "value");
  if (!parts.color.empty()) {
    surface.color = parseColor(parts.color);
    if (!surface.color)
      failInput(fmt::format("'{}' is no colour of an isosurface", parts.color), kOption,
                "try '#rrggbb', r,g,b with numbers from 0 to 1, or a name: " + colorNames());
  }
  if (!parts.opacity.empty()) surface.opacity = numberOf(parts.opacity, "opacity");
  return surface;
}

}  // namespace

void addIsosurfaceOptions(CLI::App& command, SceneOptions& options) {
  command
      .add_option(
          kOption, options.isosurfaces,
          "Surface on which the field has this value; may be given several times. COLOR: '#rrggbb', r,g,b from 0 "
          "to 1, or a name (default: the transfer function's at the value); OPACITY above 0, up to 1 (the "
          "default)")
      ->type_name("VALUE[,COLOR[,OPACITY]]")
      ->take_all()
      ->expected(1)
      ->group("Isosurfaces");
}

void setIsosurfaces(Scene& scene, const SceneOptions& options) {
  for (const std::string& text : options.isosurfaces) scene.isosurfaces.push_back(isosurfaceOf(text));
}

std::optional<std::string> isosurfaceToText(const Json& value, const std::filesystem::path&) {
  if (!value.is_object() || !value.contains("value")) return std::nullopt;
  std::string number, color, opacity;
  for (const auto& [key, part] : value.items()) {
    if (key == "color") {
      const auto text = part.is_null() ? std::string() : colorToText(part);
      if (!text) return std::nullopt;
      color = *text;
    } else if (key == "value" || key == "opacity") {
      if (!part.is_number()) return std::nullopt;
      (key == "value" ? number : opacity) = part.dump();
    } else {
      failInput("unknown key '" + key + "' of an isosurface", "isosurfaces", didYouMean(key, kKeys));
    }
  }
  if (!opacity.empty()) return number + "," + color + "," + opacity;
  return color.empty() ? number : number + "," + color;
}

Json isosurfaceFromText(const std::string& text, const std::filesystem::path&) {
  const Isosurface read = isosurfaceOf(text);
  Json json{{"value", read.value}};
  const std::string color = partsOf(text).color;
  if (read.color) json["color"] = color.find(',') == std::string::npos ? Json(color) : Json(*read.color);
  if (read.opacity != Isosurface{}.opacity) json["opacity"] = read.opacity;
  return json;
}

Json isosurfaceSchema() {
  const Json number{{"type", "number"}};
  const Json numbers{{"type", "array"}, {"items", number}, {"minItems", 3}, {"maxItems", 3}};
  return {{"type", "object"},
          {"properties",
           {{"value", number},
            {"color", {{"anyOf", {{{"type", {"string", "null"}}}, numbers}}}},
            {"opacity", {{"type", "number"}, {"exclusiveMinimum", 0}, {"maximum", 1}}}}},
          {"required", {"value"}},
          {"additionalProperties", false}};
}

}  // namespace havs
