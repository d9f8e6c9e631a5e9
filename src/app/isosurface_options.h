#pragma once
#include <CLI/CLI.hpp>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "app/scene_options.h"

namespace havs {

/// Adds --isosurface VALUE[,COLOR[,OPACITY]], which may be given several times.
void addIsosurfaceOptions(CLI::App& command, SceneOptions& options);

/// Throws Error{input} for what is no such text. An empty colour is the default one: "0.5,,0.3".
void setIsosurfaces(Scene& scene, const SceneOptions& options);

/// An isosurface of a scene file, {"value": 0.5, "color": "red", "opacity": 0.3}, as the option has it, and back. Empty
/// where it is no object of these. Throws Error{input} for a key that it does not know.
std::optional<std::string> isosurfaceToText(const nlohmann::ordered_json& value, const std::filesystem::path& folder);
nlohmann::ordered_json isosurfaceFromText(const std::string& text, const std::filesystem::path& folder);
nlohmann::ordered_json isosurfaceSchema();

}  // namespace havs
