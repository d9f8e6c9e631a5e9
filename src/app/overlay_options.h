#pragma once
#include <CLI/CLI.hpp>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "app/scene_options.h"

namespace havs {

/// Adds the options of the mesh's shape: --outline, --surface, --wireframe.
void addOverlayOptions(CLI::App& command, SceneOptions& options);

/// Throws Error{input} for what is no such setting; ranges are checked by checkScene.
void setOverlays(Scene& scene, const SceneOptions& options);

/// Settings of a scene file, "default", null for none or {"color": "red", "width": 2}, as an option has them, and back.
/// Empty where a value is neither a text nor a number nor a colour [r, g, b].
std::optional<std::string> styleToText(const nlohmann::ordered_json& value, const std::filesystem::path& folder);
nlohmann::ordered_json styleFromText(const std::string& text, const std::filesystem::path& folder);
nlohmann::ordered_json styleSchema();

/// As scene files have them; null for what the scene does without.
nlohmann::ordered_json overlayAsJson(const std::optional<Outline>& outline);
nlohmann::ordered_json overlayAsJson(const std::optional<BoundarySurface>& surface);
nlohmann::ordered_json overlayAsJson(const std::optional<WireFrame>& wireFrame);

}  // namespace havs
