#pragma once
#include <CLI/CLI.hpp>

#include "app/scene_options.h"

namespace havs {

/// Adds the options of light: lighting, lights, shadows, occlusion, scattering, modulation.
void addLightOptions(CLI::App& command, SceneOptions& options);

/// Throws Error{input} for what is no such setting, no such light; ranges are checked by checkScene.
void setLight(Scene& scene, const SceneOptions& options);

}  // namespace havs
