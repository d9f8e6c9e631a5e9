#pragma once
#include <CLI/CLI.hpp>
#include <filesystem>
#include <vector>

#include "app/max_error.h"
#include "app/scene_options.h"
#include "render/render_scene.h"

namespace havs {

/// The options of a command that draws a scene: all of the scene's, and where its picture and its report go.
struct PictureOptions {
  SceneOptions scene;
  std::vector<std::string> changes;  ///< of a scene file
  std::vector<std::filesystem::path> outputs;
  std::filesystem::path savedScene;  ///< empty: none
  int pngBits = 8;
  bool json = false;
  bool quiet = false;
};

/// Group of the help that the options of output stand in.
inline constexpr const char* kOutputGroup = "Output";

void addPictureOptions(CLI::App& command, PictureOptions& options);

/// Completes the options by the scene file, where INPUT is one (app/scene_file.h). Throws Error{input}.
void readSceneFile(PictureOptions& options);

/// The scene that was asked for. Throws Error{input} for anything wrong with it, and for pictures that cannot be
/// written.
Scene checkedScene(const PictureOptions& options);

/// Writes the pictures and prints the report that was asked for; `error`: of `havs render --max-error`. Throws Error.
void deliver(const PictureOptions& options, const Scene& scene, const RenderReport& report,
             const MaxErrorReport* error = nullptr);

}  // namespace havs
