#pragma once
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "core/progress.h"
#include "render/render_scene.h"
#include "study/choose_settings.h"

namespace havs {

/// The options of `havs render --max-error` as typed.
struct MaxErrorOptions {
  std::optional<double> most;
  std::optional<std::string> measure;
  bool verify = false;
};
void addMaxErrorOptions(CLI::App& command, MaxErrorOptions& options);

/// What was asked for; none without --max-error. Throws Error{input}: a bound or a measure that is none, an option that
/// needs --max-error.
std::optional<ErrorGoal> goalOf(const MaxErrorOptions& options);

/// What was chosen for it and, where it was verified, what came of it.
struct MaxErrorReport {
  ErrorGoal goal;
  ChosenSettings chosen;
  std::optional<double> trueError;
  double verifyMs = 0;
};

/// Chooses settings, puts them into the scene, draws it, and measures its true error where `verify` is set. Throws as
/// chooseSettings and renderScene.
RenderReport renderWithin(const ErrorGoal& goal, bool verify, Scene& scene, MaxErrorReport& error,
                          const Progress& progress);

nlohmann::ordered_json errorAsJson(const MaxErrorReport& error);
std::string errorAsText(const MaxErrorReport& error);

}  // namespace havs
