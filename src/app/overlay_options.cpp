#include "app/overlay_options.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <functional>
#include <sstream>

#include "app/color_form.h"
#include "core/error.h"
#include "core/nearest_name.h"
#include "image/color_names.h"

namespace havs {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kDefault = "default";
constexpr const char* kNone = "none";
constexpr const char* kFlat = "flat";
constexpr const char* kUnlit = "none";
const std::vector<std::string> kShadings{kFlat, kUnlit};

struct Named {
  std::string name, value;
};

/// "name=value,name=value". What has no = belongs to the value before it: colours of three numbers have commas.
std::vector<Named> settingsIn(const std::string& text) {
  std::vector<Named> settings;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, ',');) {
    const std::size_t equals = part.find('=');
    if (equals == std::string::npos && !settings.empty()) {
      settings.back().value += "," + part;
    } else {
      settings.push_back({part.substr(0, equals), equals == std::string::npos ? "" : part.substr(equals + 1)});
    }
  }
  return settings;
}

/// A setting's name, and what reads its value.
struct Setting {
  std::string name;
  std::function<void(const std::string& value)> set;
};

void read(const std::string& text, const char* option, const std::vector<Setting>& settings) {
  if (text == kDefault) return;
  std::vector<std::string> names;
  for (const Setting& setting : settings) names.push_back(setting.name);
  const std::vector<Named> given = settingsIn(text);
  if (given.empty()) failInput("no setting is given", option, fmt::format("write {}, or NAME=VALUE", kDefault));
  for (const auto& [name, value] : given) {
    const auto setting =
        std::find_if(settings.begin(), settings.end(), [&n = name](const Setting& s) { return s.name == n; });
    if (setting == settings.end())
      failInput(fmt::format("unknown setting '{}'", name), option, didYouMean(name, names));
    if (value.empty())
      failInput(fmt::format("'{}' has no value", name), option,
                fmt::format("write {}=VALUE, or '{}' for all as they are", name, kDefault));
    setting->set(value);
  }
}

Setting colorSetting(Color& color, const char* option) {
  return {"color", [&color, option](const std::string& value) {
            const auto parsed = parseColor(value);
            if (!parsed)
              failInput(fmt::format("'{}' is no colour", value), option,
                        "try '#rrggbb', r,g,b with numbers from 0 to 1, or a name: " + colorNames());
            color = *parsed;
          }};
}

template <class Number>
Setting numberSetting(const char* name, Number& number, const char* option) {
  return {name, [&number, name, option](const std::string& value) {
            double parsed = 0;
            const char* const end = value.data() + value.size();
            const auto [last, error] = std::from_chars(value.data(), end, parsed);
            if (error != std::errc{} || last != end)
              failInput(fmt::format("'{}' is no number", value), option, fmt::format("write {}=NUMBER", name));
            number = parsed;
          }};
}

Outline outlineOf(const std::string& text) {
  constexpr const char* kOption = "--outline";
  Outline outline;
  read(text, kOption, {colorSetting(outline.color, kOption), numberSetting("width", outline.width, kOption)});
  return outline;
}

BoundarySurface surfaceOf(const std::string& text) {
  constexpr const char* kOption = "--surface";
  BoundarySurface surface;
  const auto setShading = [&](const std::string& value) {
    if (value != kFlat && value != kUnlit)
      failInput(fmt::format("unknown shading '{}'", value), kOption, didYouMean(value, kShadings));
    surface.shaded = value == kFlat;
  };
  read(text, kOption,
       {colorSetting(surface.color, kOption),
        numberSetting("opacity", surface.opacity, kOption),
        {"shading", setShading}});
  return surface;
}

WireFrame wireFrameOf(const std::string& text) {
  constexpr const char* kOption = "--wireframe";
  WireFrame wire;
  read(text, kOption,
       {colorSetting(wire.color, kOption), numberSetting("width", wire.width, kOption),
        numberSetting("opacity", wire.opacity, kOption), numberSetting("feature_angle", wire.featureAngle, kOption)});
  return wire;
}

void addStyle(CLI::App& command, const char* name, std::optional<std::string>& value, const std::string& description) {
  command.add_option(name, value, description)->type_name("SETTINGS")->group("The mesh's shape");
}

}  // namespace

void addOverlayOptions(CLI::App& command, SceneOptions& options) {
  addStyle(command, "--outline", options.outline,
           fmt::format("The box around the mesh: '{}', '{}', or color=gray,width={} or some of these; the width in "
                       "pixels",
                       kDefault, kNone, Outline{}.width));
  addStyle(command, "--surface", options.surface,
           fmt::format(
               "The mesh's boundary, inside the volume: '{}', '{}', or color=#cccccc,opacity={},shading={}|{} or some "
               "of these",
               kDefault, kNone, BoundarySurface{}.opacity, kFlat, kUnlit));
  addStyle(
      command, "--wireframe", options.wireFrame,
      fmt::format("The edges of the boundary: '{}', '{}', or color=black,width={},opacity={},feature_angle=DEGREES or "
                  "some of these; the angle leaves out edges between faces that differ by no more",
                  kDefault, kNone, WireFrame{}.width, WireFrame{}.opacity));
}

void setOverlays(Scene& scene, const SceneOptions& options) {
  auto asked = [](const std::optional<std::string>& text) { return text && *text != kNone; };
  if (asked(options.outline)) scene.overlays.outline = outlineOf(*options.outline);
  if (asked(options.surface)) scene.overlays.surface = surfaceOf(*options.surface);
  if (asked(options.wireFrame)) scene.overlays.wireFrame = wireFrameOf(*options.wireFrame);
}

std::optional<std::string> styleToText(const Json& value, const std::filesystem::path&) {
  if (value == kDefault) return kDefault;
  if (value.is_null()) return kNone;
  if (!value.is_object()) return std::nullopt;
  std::string text;
  for (const auto& [name, part] : value.items()) {
    const auto written = part.is_number() ? std::optional(part.dump()) : colorToText(part);
    if (!written) return std::nullopt;
    text += (text.empty() ? "" : ",") + name + "=" + *written;
  }
  return text.empty() ? kDefault : text;
}

Json styleFromText(const std::string& text, const std::filesystem::path&) {
  if (text == kDefault) return text;
  if (text == kNone) return {};
  Json style = Json::object();
  for (const auto& [name, value] : settingsIn(text)) {
    const Json number = Json::parse(value, nullptr, false);
    style[name] = number.is_number() ? number : colorFromText(value);
  }
  return style;
}

Json styleSchema() {
  Json value = colorSchema();
  value["anyOf"].push_back({{"type", "number"}});
  return {
      {"anyOf", {{{"const", kDefault}}, {{"type", "null"}}, {{"type", "object"}, {"additionalProperties", value}}}}};
}

Json overlayAsJson(const std::optional<Outline>& outline) {
  if (!outline) return nullptr;
  return {{"color", outline->color}, {"width", outline->width}};
}

Json overlayAsJson(const std::optional<BoundarySurface>& surface) {
  if (!surface) return nullptr;
  return {{"color", surface->color}, {"opacity", surface->opacity}, {"shading", surface->shaded ? kFlat : kUnlit}};
}

Json overlayAsJson(const std::optional<WireFrame>& wireFrame) {
  if (!wireFrame) return nullptr;
  Json json{{"color", wireFrame->color}, {"width", wireFrame->width}, {"opacity", wireFrame->opacity}};
  if (wireFrame->featureAngle) json["feature_angle"] = *wireFrame->featureAngle;
  return json;
}

}  // namespace havs
