#pragma once
#include <CLI/CLI.hpp>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "scene/scene.h"

namespace havs {

/// One view of a scene file that has several: what of it is set goes before the scene's own.
struct ViewOptions {
  std::optional<std::string> camera, projection;
  std::vector<std::filesystem::path> outputs;
};

/// The options of a scene as typed; unset ones leave the default (or what --paper says).
struct SceneOptions {
  std::string mesh, plot3dSolution;
  std::optional<std::string> tetgenSwitches, field, transferFunction, domain, size, camera, background, mode;
  std::optional<std::string> device, instructionSet, visibility, k, sort, lookup, tableFormat, targetFormat;
  std::optional<std::string> projection;
  std::optional<double> unitLength, earlyTermination;
  std::optional<int> tableSize, threads, repeat;
  std::optional<std::string> threshold, maxMemory;
  std::vector<std::string> clipPlanes, clipBoxes, cutBoxes;
  std::vector<std::string> isosurfaces;
  std::optional<std::string> outline, surface, wireFrame;
  bool compositeLate = false;
  bool paper = false;
  std::optional<std::string> lighting, occlusion, scattering;
  std::vector<std::string> lights;
  std::optional<double> modulation;
  bool shadows = false;
  std::vector<ViewOptions> views;  ///< of a scene file (app/scene_views.h)
};

/// Adds INPUT and all options of a scene to a command. The help of an option that names a row of a table lists the
/// table's rows.
void addSceneOptions(CLI::App& command, SceneOptions& options);

/// The scene that was asked for. Throws Error{input} for a value out of range, and for a name that its table does not
/// know.
Scene makeScene(const SceneOptions& options);

}  // namespace havs
