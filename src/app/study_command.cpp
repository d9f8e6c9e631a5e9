// havs study: what accuracy costs in time.
#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "app/commands.h"
#include "app/limit_threads.h"
#include "app/scene_file.h"
#include "app/scene_options.h"
#include "app/scene_views.h"
#include "app/table_names.h"
#include "core/error.h"
#include "render/devices.h"
#include "render/effects.h"
#include "render/lookups.h"
#include "study/fingerprint.h"
#include "study/page.h"
#include "study/study.h"

namespace havs {
namespace {

constexpr const char* kGroup = "Study";
constexpr const char* kSize = "512x512";
constexpr const char* kQuickSize = "256x256";
constexpr int kQuickRepeat = 3;
constexpr int kQuickCombinations = 6;
/// What lit scenes are drawn with by default, so that with and without them nothing else differs.
constexpr const char* kLookupForEffects = "exact";

struct StudyOptions {
  SceneOptions scene;
  std::vector<std::string> meshes, cameras, axes;
  std::filesystem::path folder;
  std::optional<int> repeat, combinations;
  int seed = 1, keepMegabytes = 2048;
  bool effects = false, quick = false, restart = false, json = false, quiet = false;
};

std::string axesForHelp() {
  std::vector<std::string> names;
  for (const StudyAxis& row : axes())
    names.push_back(fmt::format("{} ({})", row.name, fmt::join(row.values(false), ",")));
  return fmt::format("{}", fmt::join(names, ", "));
}

std::string effectsForHelp() {
  std::vector<std::string> names;
  for (const Effect& row : effects()) names.push_back(row.name);
  return fmt::format("{}", fmt::join(names, ", "));
}

/// Options of a scene that a study takes otherwise.
void replaceSceneOptions(CLI::App& command, StudyOptions& options) {
  for (const char* name : {"INPUT", "--camera", "--repeat"}) command.remove_option(command.get_option(name));
  command.add_option("INPUT", options.meshes, "Meshes: " + meshExtensions() + "; or one scene file: .json")
      ->required()
      ->type_name("");
  command
      .add_option("--camera", options.cameras,
                  "AZIMUTH,ELEVATION[,ZOOM] in degrees, a JSON object, or a file with one; may be given several times")
      ->type_name("CAMERA")
      ->take_all()
      ->expected(1)
      ->group("Camera and picture");
  command.get_option("--device")
      ->description(fmt::format("Where to draw (default {}):{}", Scene{}.device, rowsForHelp(renderDevices())));
  command.get_option("--lookup")
      ->description(
          fmt::format("How a segment's colour is found (default {}):{}", Scene{}.lookup, rowsForHelp(lookups())));
  command.get_option("--size")->description(fmt::format("Pixels (default {}; with --quick {})", kSize, kQuickSize));
}

/// As a shell takes it.
std::string quoted(const std::string& text) {
  if (!text.empty() && text.find_first_of(" \t\n'\"\\$`{}[]()*?;&|<>#~!") == std::string::npos) return text;
  std::string result = "'";
  for (const char c : text) result += c == '\'' ? "'\\''" : std::string(1, c);
  return result + "'";
}

/// The command line, options in the order of the help; without those named.
std::string commandLineOf(const CLI::App& command, const std::vector<std::string>& without) {
  std::string text = "havs " + command.get_name();
  for (const CLI::Option* option : command.get_options()) {
    const std::string name = option->get_name();
    if (option->count() == 0 || std::find(without.begin(), without.end(), name) != without.end()) continue;
    const bool isFlag = option->get_expected_max() == 0;
    if (isFlag) text += " " + name;
    for (const std::string& value : isFlag ? std::vector<std::string>{} : option->results())
      text += (option->get_positional() ? " " : " " + name + " ") + quoted(value);
  }
  return text;
}

/// Numbers that must not be negative.
template <class Number>
Number counted(int value, int least, const char* option) {
  if (value < least) failInput(fmt::format("must be at least {}, not {}", least, value), option);
  return static_cast<Number>(value);
}

/// The options of one INPUT: of a scene file, those that the command line leaves unset are the file's.
SceneOptions optionsOf(const StudyOptions& options, const std::string& input) {
  SceneOptions one = options.scene;
  one.mesh = input;
  if (isSceneFile(input)) {
    if (options.meshes.size() > 1)
      failInput("a scene file is studied by itself", input, "name meshes, or one scene file");
    std::vector<std::filesystem::path> ignored;
    readSceneFile(one, ignored, {});
  }
  one.repeat.reset();
  if (!one.size) one.size = options.quick ? kQuickSize : kSize;
  if (!one.device) one.device = Scene{}.device;
  if (!one.lookup && !one.paper) one.lookup = options.effects ? kLookupForEffects : Scene{}.lookup;
  return one;
}

std::vector<Scene> scenesOf(const StudyOptions& options) {
  std::vector<Scene> scenes;
  for (const std::string& input : options.meshes) {
    SceneOptions one = optionsOf(options, input);
    if (options.cameras.empty())
      for (const SceneOptions& view : optionsOfViews(one)) scenes.push_back(makeScene(view));
    for (const std::string& camera : options.cameras) {
      one.camera = camera;
      scenes.push_back(makeScene(one));
    }
  }
  return scenes;
}

/// A scene file may change between two runs of one command line.
std::string contentOfSceneFile(const StudyOptions& options) {
  const std::string& input = options.meshes.front();
  return isSceneFile(input) ? " # scene " + fingerprintOf(std::filesystem::path(input)) : "";
}

/// A study's settings are numbers, the same for every mesh and camera.
void refuseAutomaticK(const std::vector<Scene>& scenes) {
  for (const Scene& scene : scenes)
    if (scene.kAuto) failInput("a study measures every k by itself", "--k auto", "give a number, and --axis k=1,2,...");
}

StudyRequest requestOf(const StudyOptions& options, const CLI::App& command) {
  const std::vector<std::string> justNow{"--restart", "--json", "--quiet"};
  StudyRequest request;
  request.command = commandLineOf(command, justNow);
  request.identity =
      commandLineOf(command, {"--restart", "--json", "--quiet", "--out", "--keep-memory", "--max-memory"}) +
      contentOfSceneFile(options);
  request.scenes = scenesOf(options);
  refuseAutomaticK(request.scenes);
  request.effects = options.effects;
  if (!options.effects || !options.axes.empty()) request.axes = chooseAxes(options.axes, options.quick);
  request.repeat = counted<int>(options.repeat.value_or(options.quick ? kQuickRepeat : request.repeat), 1, "--repeat");
  request.combinations = options.quick ? kQuickCombinations : request.combinations;
  if (options.combinations) request.combinations = counted<std::size_t>(*options.combinations, 0, "--combinations");
  request.seed = counted<std::uint64_t>(options.seed, 0, "--seed");
  request.keepBytes = counted<std::size_t>(options.keepMegabytes, 0, "--keep-memory") << 20;
  request.folder = options.folder;
  request.restart = options.restart;
  return request;
}

void addStudyOptions(CLI::App& command, StudyOptions& options) {
  auto add = [&](const char* name, auto& variable, const char* value, const std::string& description) {
    return command.add_option(name, variable, description)->type_name(value)->group(kGroup);
  };
  add("--out", options.folder, "DIR",
      "Folder for report.html, study.json, study.csv, images/ and runs.jsonl, from which an interrupted study goes on")
      ->required();
  add("--axis", options.axes, "NAME[=VALUE,...]",
      "What is varied, and its values; may be given several times (default: all: " + axesForHelp() + ")")
      ->take_all()
      ->expected(1);
  add("--repeat", options.repeat, "N",
      fmt::format("Timed drawings of each setting (default {}; with --quick {})", StudyRequest{}.repeat, kQuickRepeat));
  add("--combinations", options.combinations, "N",
      fmt::format("Settings that combine what did well, at most, of each mesh and camera (default {}; with --quick {})",
                  StudyRequest{}.combinations, kQuickCombinations));
  add("--seed", options.seed, "N", "Of the order in which settings are visited (default 1)");
  add("--keep-memory", options.keepMegabytes, "MB", "Memory for tables and targets kept between visits (default 2048)");
  command
      .add_flag("--effects", options.effects,
                "What each effect costs: the picture with it and without it, each that the options ask for left out in "
                "turn, and each other added in a default form (" +
                    effectsForHelp() + "). Alone it replaces the axes, and the lookup is 'exact' by default")
      ->group(kGroup);
  command.add_flag("--quick", options.quick, "Fewer values, smaller pictures: a minute instead of several")
      ->group(kGroup);
  command.add_flag("--restart", options.restart, "Forget what the folder's runs.jsonl holds")->group(kGroup);
  command.add_flag("--json", options.json, "Print study.json")->group(kGroup);
  command.add_flag("--quiet", options.quiet, "Print nothing but errors (and what --json asks for)")->group(kGroup);
}

}  // namespace

void addStudyCommand(CLI::App& program) {
  CLI::App* command = program.add_subcommand(
      "study",
      "Measure what accuracy costs in time: each setting varied by itself, then what did well together, every "
      "picture compared with the ground truth");
  auto options = std::make_shared<StudyOptions>();
  addSceneOptions(*command, options->scene);
  replaceSceneOptions(*command, *options);
  addStudyOptions(*command, *options);
  command->callback([options, command] {
    const StudyRequest request = requestOf(*options, *command);
    limitThreads(request.scenes.front().threads);
    const StudyReport report = runStudy(request, terminalProgress(options->quiet));
    if (hasStudyPage()) rewriteStudyPage(request.folder);
    if (options->json)
      fmt::print("{}", studyJson(report));
    else if (!options->quiet)
      fmt::print("{}report    {}\n", studyText(report),
                 (request.folder / (hasStudyPage() ? "report.html" : "study.json")).string());
  });
}

}  // namespace havs
