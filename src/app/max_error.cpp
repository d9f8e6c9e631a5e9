// havs render --max-error.
#include "app/max_error.h"

#include <fmt/format.h>

#include <chrono>

#include "app/table_names.h"
#include "core/error.h"
#include "core/parallel.h"
#include "study/axes.h"

namespace havs {

void addMaxErrorOptions(CLI::App& command, MaxErrorOptions& options) {
  constexpr const char* kGroup = "Error";
  command
      .add_option("--max-error", options.most,
                  "Choose k, lookup and table: the cheapest whose error against the ground truth stays below this, "
                  "estimated on a small picture first")
      ->type_name("ERROR")
      ->group(kGroup);
  command
      .add_option(
          "--error-measure", options.measure,
          fmt::format("What --max-error bounds (default {}):{}", ErrorGoal{}.measure, rowsForHelp(errorMeasures())))
      ->type_name("NAME")
      ->group(kGroup);
  command.add_flag("--verify", options.verify, "Draw the ground truth afterwards and tell the true error")
      ->group(kGroup);
}

std::optional<ErrorGoal> goalOf(const MaxErrorOptions& options) {
  if (!options.most) {
    if (options.verify) failInput("has an effect with --max-error only", "--verify", "name the error with --max-error");
    if (options.measure)
      failInput("has an effect with --max-error only", "--error-measure", "name the error with --max-error");
    return std::nullopt;
  }
  ErrorGoal goal{*options.most};
  if (options.measure) goal.measure = *options.measure;
  checkGoal(goal);
  return goal;
}

RenderReport renderWithin(const ErrorGoal& goal, bool verify, Scene& scene, MaxErrorReport& error,
                          const Progress& progress) {
  using Clock = std::chrono::steady_clock;
  error.goal = goal;
  StageTimes stages;
  const ThreadLimit limit(scene.threads);
  const PreparedScene prepared = prepareScene(scene, stages, progress);
  error.chosen = chooseSettings(scene, prepared, goal, progress);
  scene = error.chosen.scene;
  RenderReport report = renderScene(scene, prepared, stages, progress);
  const auto start = Clock::now();
  if (verify) error.trueError = trueError(scene, prepared, report.image, goal);
  error.verifyMs = std::chrono::duration<double, std::milli>(Clock::now() - start).count();
  return report;
}

nlohmann::ordered_json errorAsJson(const MaxErrorReport& error) {
  nlohmann::ordered_json json{{"asked", error.goal.most},
                              {"measure", error.goal.measure},
                              {"settings", settingsLabel(error.chosen.scene)},
                              {"estimate", error.chosen.estimate},
                              {"margin", kErrorMargin},
                              {"probe_size", {error.chosen.probeWidth, error.chosen.probeHeight}},
                              {"candidates", error.chosen.candidates},
                              {"probes", error.chosen.probes},
                              {"probe_ms", error.chosen.probeMs}};
  json["true_error"] = error.trueError ? nlohmann::ordered_json(*error.trueError) : nlohmann::ordered_json();
  if (error.trueError) json["verify_ms"] = error.verifyMs;
  return json;
}

std::string errorAsText(const MaxErrorReport& error) {
  const ChosenSettings& chosen = error.chosen;
  std::string text = fmt::format("{:<9}{}: estimated {:.2g} ({}), asked {:g}\n", "error", settingsLabel(chosen.scene),
                                 chosen.estimate, error.goal.measure, error.goal.most);
  text += fmt::format("{:<9}{} of {} settings at {} x {} in {:.0f} ms\n", "probe", chosen.probes, chosen.candidates,
                      chosen.probeWidth, chosen.probeHeight, chosen.probeMs);
  if (error.trueError)
    text += fmt::format("{:<9}true error {:.2g}, {} what was asked; the ground truth took {:.0f} ms\n", "verified",
                        *error.trueError, *error.trueError <= error.goal.most ? "within" : "MORE THAN", error.verifyMs);
  return text;
}

}  // namespace havs
