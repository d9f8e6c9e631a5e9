#pragma once
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "render/render_scene.h"
#include "scene/scene.h"

namespace havs {

/// All that is known of a drawing, keys in snake_case (docs/01-start.md); times in milliseconds, memory in bytes.
nlohmann::ordered_json reportAsJson(const Scene& scene, const RenderReport& report,
                                    const std::vector<std::filesystem::path>& outputs);

/// The same in a few lines for people.
std::string reportAsText(const Scene& scene, const RenderReport& report,
                         const std::vector<std::filesystem::path>& outputs);

}  // namespace havs
