#include "app/light_options.h"

#include <fmt/format.h>

#include <charconv>
#include <functional>
#include <sstream>

#include "core/error.h"
#include "core/nearest_name.h"

namespace havs {
namespace {

constexpr const char* kGroup = "Light";
constexpr const char* kDefault = "default";
constexpr const char* kNone = "none";

/// A setting's name and where its value goes.
struct Setting {
  std::string name;
  std::function<void(double)> set;
};

double numberOf(const std::string& text, const std::string& option, const std::string& what) {
  double number = 0;
  const char* const end = text.data() + text.size();
  const auto [last, error] = std::from_chars(text.data(), end, number);
  if (error != std::errc{} || last != end) failInput(fmt::format("'{}' is no number", text), option, what);
  return number;
}

/// "name=value,name=value", or "default".
void read(const std::string& text, const std::string& option, const std::vector<Setting>& settings) {
  if (text == kDefault) return;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, ',');) {
    const std::size_t equals = part.find('=');
    const std::string name = part.substr(0, equals);
    std::vector<std::string> names;
    for (const Setting& setting : settings) names.push_back(setting.name);
    const auto setting =
        std::find_if(settings.begin(), settings.end(), [&](const Setting& s) { return s.name == name; });
    if (setting == settings.end())
      failInput(fmt::format("unknown setting '{}'", name), option, didYouMean(name, names));
    const std::string example = fmt::format("write {}=VALUE, or '{}' for all as they are", name, kDefault);
    if (equals == std::string::npos) failInput(fmt::format("'{}' has no value", part), option, example);
    setting->set(numberOf(part.substr(equals + 1), option, example));
  }
}

int wholeNumber(double value, const std::string& option) {
  if (!(value == static_cast<int>(value)))
    failInput(fmt::format("{} is no whole number", value), option, "this setting counts");
  return static_cast<int>(value);
}

Lighting lightingOf(const std::string& text) {
  Lighting lighting;
  read(text, "--lighting",
       {{"ambient", [&](double v) { lighting.ambient = v; }},
        {"diffuse", [&](double v) { lighting.diffuse = v; }},
        {"specular", [&](double v) { lighting.specular = v; }},
        {"shininess", [&](double v) { lighting.shininess = wholeNumber(v, "--lighting"); }},
        {"silhouettes", [&](double v) { lighting.silhouettes = v; }}});
  return lighting;
}

AmbientOcclusion occlusionOf(const std::string& text) {
  AmbientOcclusion occlusion;
  read(text, "--occlusion",
       {{"radius", [&](double v) { occlusion.radius = v; }},
        {"directions", [&](double v) { occlusion.directions = wholeNumber(v, "--occlusion"); }}});
  return occlusion;
}

AmbientScattering scatteringOf(const std::string& text) {
  AmbientScattering scattering;
  read(text, "--scattering",
       {{"albedo", [&](double v) { scattering.albedo = v; }},
        {"anisotropy", [&](double v) { scattering.anisotropy = v; }},
        {"radius", [&](double v) { scattering.radius = v; }}});
  return scattering;
}

/// "head[:INTENSITY]", "directional:X,Y,Z[:INTENSITY]", "point:X,Y,Z[:INTENSITY]".
SceneLight lightOf(const std::string& text) {
  constexpr const char* kForm = "write head, directional:X,Y,Z or point:X,Y,Z, and :INTENSITY behind it";
  std::vector<std::string> parts;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, ':');) parts.push_back(part);
  SceneLight light;
  if (parts.empty()) failInput("a light needs a kind", "--light", kForm);
  if (parts[0] == "directional") {
    light.kind = SceneLight::Kind::directional;
  } else if (parts[0] == "point") {
    light.kind = SceneLight::Kind::point;
  } else if (parts[0] != "head") {
    failInput(fmt::format("unknown kind of light '{}'", parts[0]), "--light", kForm);
  }
  std::size_t next = 1;
  if (light.kind != SceneLight::Kind::head) {
    std::istringstream place(parts.size() > 1 ? parts[next++] : "");
    std::vector<double> numbers;
    for (std::string part; std::getline(place, part, ',');) numbers.push_back(numberOf(part, "--light", kForm));
    if (numbers.size() != 3) failInput(fmt::format("'{}' has not three numbers for its place", text), "--light", kForm);
    light.place = {numbers[0], numbers[1], numbers[2]};
  }
  if (parts.size() > next) light.intensity = numberOf(parts[next++], "--light", kForm);
  if (parts.size() > next) failInput(fmt::format("'{}' says too much", text), "--light", kForm);
  return light;
}

/// What a text asks for; nothing for "none".
template <class Value>
void setUnlessNone(std::optional<Value>& value, const std::optional<std::string>& text,
                   Value (*valueOf)(const std::string& text)) {
  if (text && *text != kNone) value = valueOf(*text);
}

void addText(CLI::App& command, const char* name, std::optional<std::string>& value, const std::string& description) {
  command.add_option(name, value, description)->type_name("SETTINGS")->group(kGroup);
}

}  // namespace

void addLightOptions(CLI::App& command, SceneOptions& options) {
  const Lighting lighting;
  const AmbientOcclusion occlusion;
  const AmbientScattering scattering;
  addText(command, "--lighting", options.lighting,
          fmt::format("Light the volume by the gradient of the scalar: 'default', 'none', or "
                      "ambient={},diffuse={},specular={},shininess={},silhouettes={} or some of these",
                      lighting.ambient, lighting.diffuse, lighting.specular, lighting.shininess, lighting.silhouettes));
  command
      .add_option("--light", options.lights,
                  fmt::format("head, directional:X,Y,Z (towards it) or point:X,Y,Z (mesh units), and :INTENSITY; up to "
                              "{} (default: one head light)",
                              kMostLights))
      ->type_name("LIGHT")
      ->take_all()
      ->expected(1)
      ->group(kGroup);
  command.add_flag("--shadows", options.shadows, "Lights are dimmed by what they go through")->group(kGroup);
  addText(command, "--occlusion", options.occlusion,
          fmt::format("Ambient occlusion: 'default', 'none', or radius={},directions={}; the radius in bounding radii",
                      occlusion.radius, occlusion.directions));
  addText(command, "--scattering", options.scattering,
          fmt::format("Ambient scattering: 'default', 'none', or albedo={},anisotropy={},radius={}", scattering.albedo,
                      scattering.anisotropy, scattering.radius));
  command
      .add_option("--modulation", options.modulation,
                  "Fade the volume where the scalar hardly changes: 0 (default) not at all, 1 in proportion to the "
                  "gradient")
      ->type_name("SHARE")
      ->group(kGroup);
}

void setLight(Scene& scene, const SceneOptions& options) {
  setUnlessNone(scene.lighting, options.lighting, lightingOf);
  for (const std::string& text : options.lights) scene.lights.push_back(lightOf(text));
  setUnlessNone(scene.occlusion, options.occlusion, occlusionOf);
  setUnlessNone(scene.scattering, options.scattering, scatteringOf);
  if (options.modulation) scene.modulation = *options.modulation;
  scene.shadows = options.shadows;
}

}  // namespace havs
