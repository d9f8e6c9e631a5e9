#pragma once
#include <CLI/CLI.hpp>
#include <filesystem>
#include <span>
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

/// What was asked for: one scene, or one for each view of the scene file, which differ by the camera alone, and where
/// its picture goes.
struct AskedPicture {
  Scene scene;
  std::vector<std::filesystem::path> outputs;
};
/// At least one. Throws Error{input} for anything wrong with the scene, and for pictures that cannot be written.
std::vector<AskedPicture> askedPictures(const PictureOptions& options);
/// Their scenes.
std::vector<Scene> scenesOf(std::span<const AskedPicture> pictures);

/// Writes the pictures and prints the reports, one for each, that were asked for; `error`: of `havs render
/// --max-error`, which takes one picture. Throws Error.
void deliver(const PictureOptions& options, std::span<const AskedPicture> pictures,
             std::span<const RenderReport> reports, const MaxErrorReport* error = nullptr);

}  // namespace havs
