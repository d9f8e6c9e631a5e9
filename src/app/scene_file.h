#pragma once
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "app/scene_options.h"

namespace havs {

/// Whether an INPUT is a scene file, not a mesh: by its ending, .json.
bool isSceneFile(const std::string& input);

/// Reads the scene file that stands as `options.mesh` into all options that are unset, and into `outputs` where that is
/// empty; so the command line wins. Its paths are relative to its folder, but those of outputs. `changes`: "key=value",
/// "camera.zoom=2", put into the file's content before it is read; the value JSON, or else a text. Throws Error{input}:
/// no such file, no JSON, another version, an unknown key (naming the nearest), a value of another kind.
void readSceneFile(SceneOptions& options, std::vector<std::filesystem::path>& outputs,
                   std::span<const std::string> changes);

/// The options that are set as a scene file that is to stand at `file`: readSceneFile gives them back. Ends with a line
/// break.
std::string sceneFileOf(const SceneOptions& options, std::span<const std::filesystem::path> outputs,
                        const std::filesystem::path& file);

/// The JSON schema of scene files (draft 2020-12), as docs/scene.schema.json has it.
std::string sceneFileSchema();

}  // namespace havs
