#pragma once
#include <CLI/CLI.hpp>

#include "app/scene_options.h"

namespace havs {

/// Adds the options of what is cut off the mesh: clip planes and boxes, the threshold.
void addClipOptions(CLI::App& command, SceneOptions& options);

/// Throws Error{input}: not as many numbers as are wanted, and as checkClipping (scene/clip_scene.h).
void setClipping(Scene& scene, const SceneOptions& options);

}  // namespace havs
