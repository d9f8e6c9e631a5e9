#include "app/scene_options.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "app/clip_options.h"
#include "app/isosurface_options.h"
#include "app/light_options.h"
#include "app/overlay_options.h"
#include "app/read_options.h"
#include "app/table_names.h"
#include "core/error.h"
#include "core/memory_budget.h"
#include "core/nearest_name.h"
#include "image/color_names.h"
#include "render/devices.h"
#include "render/lookups.h"
#include "render/modes.h"
#include "render/native/instruction_sets.h"
#include "render/plan.h"
#include "render/visibility.h"
#include "sort/face_order.h"
#include "transfer/transfer_function.h"

namespace havs {
namespace {

const std::vector<std::string> kProjections{"perspective", "orthographic"};

/// Adds an option to a group of the help. `value` names what is to be given, as the help shows it.
template <class T>
void add(CLI::App& command, const char* group, const char* name, T& variable, const char* value,
         const std::string& description) {
  command.add_option(name, variable, description)->type_name(value)->group(group);
}

void addInputOptions(CLI::App& command, SceneOptions& options) {
  constexpr const char* kGroup = "Mesh and field";
  command.add_option("INPUT", options.mesh, "Mesh: " + meshExtensions())->required()->type_name("");
  add(command, kGroup, "--field", options.field, "NAME",
      "Field, also NAME:x, NAME:2, NAME:magnitude, point:NAME, cell:NAME (default: the first)");
  add(command, kGroup, "--q", options.plot3dSolution, "FILE", "PLOT3D's solution (default: found beside the grid)");
  add(command, kGroup, "--tetgen", options.tetgenSwitches, "SWITCHES",
      "TetGen's switches for a surface (default " + Scene{}.tetgenSwitches + ")");
  add(command, kGroup, kMaxMemoryOption, options.maxMemory, "SIZE", kMaxMemoryHelp);
}

void addTransferOptions(CLI::App& command, SceneOptions& options) {
  constexpr const char* kGroup = "Transfer function";
  add(command, kGroup, "--tf", options.transferFunction, "FILE|PRESET",
      fmt::format("JSON, ParaView's JSON or XML, TF.bin, or a preset (default {}):{}", Scene{}.transferFunction,
                  rowsForHelp(transferPresets())));
  add(command, kGroup, "--unit-length", options.unitLength, "LENGTH",
      "Thickness that opacity is meant for, in mesh units (default: the file's, else 1/20 of the diagonal)");
  add(command, kGroup, "--domain", options.domain, "LOW,HIGH",
      "Data values at the ends of the transfer function (default: the field's)");
}

void addPictureOptions(CLI::App& command, SceneOptions& options) {
  constexpr const char* kGroup = "Camera and picture";
  add(command, kGroup, "--mode", options.mode, "NAME",
      fmt::format("What a pixel shows (default {}):{}", Scene{}.mode, rowsForHelp(modes())));
  add(command, kGroup, "--size", options.size, "WxH",
      fmt::format("Pixels (default {}x{})", Scene{}.width, Scene{}.height));
  add(command, kGroup, "--camera", options.camera, "CAMERA",
      "AZIMUTH,ELEVATION[,ZOOM] in degrees, a JSON object, or a file with one");
  add(command, kGroup, "--projection", options.projection, "NAME", "perspective (default) or orthographic");
  add(command, kGroup, "--background", options.background, "COLOR|BOTTOM..TOP",
      "none, '#rrggbb', r,g,b from 0 to 1, or a name (default white); or a gradient between two of these: " +
          colorNames());
}

/// "3d 128, 2d 512"
std::string ownTableSizes() {
  std::string text;
  for (const Lookup& row : lookups())
    if (const LookupResource* table = tableOf(row))
      text += fmt::format("{}{} {}", text.empty() ? "" : ", ", row.name, table->ownSize);
  return text;
}

void addMethodOptions(CLI::App& command, SceneOptions& options) {
  constexpr const char* kGroup = "Method";
  const Scene defaults;
  auto addTable = [&](const char* name, std::optional<std::string>& value, const char* what, const std::string& chosen,
                      const auto& rows) {
    add(command, kGroup, name, value, "NAME", fmt::format("{} (default {}):{}", what, chosen, rowsForHelp(rows)));
  };
  addTable("--device", options.device, "Where to draw",
           fmt::format("native; {} for what only OpenGL draws", defaults.device), renderDevices());
  add(command, kGroup, "--simd", options.instructionSet, "NAME",
      fmt::format("Instruction set of the native device (default: the widest of the processor):{}",
                  rowsForHelp(instructionSets())));
  addTable("--visibility", options.visibility, "How a pixel's fragments are ordered", defaults.visibility,
           visibilityMethods());
  add(command, kGroup, "--k", options.k, "N|auto",
      fmt::format("Entries of the k-buffer (default {}); auto: the fewest that bring every fragment into order",
                  defaults.k));
  addTable("--sort", options.sort, "Order in which faces are drawn", defaults.sort, sortMethods());
  addTable(
      "--lookup", options.lookup, "How a segment's colour is found",
      fmt::format(
          "auto: exact where cells hold at most 2 knots of the transfer function and no table is asked for, else {}",
          defaults.lookup),
      lookups());
  add(command, kGroup, "--table", options.tableSize, "N",
      "Size of the table: entries along each axis, unless the lookup says otherwise (default: " + ownTableSizes() +
          ")");
  addTable("--table-format", options.tableFormat, "Numbers of the table", defaults.tableFormat, tableFormats());
  addTable("--target-format", options.targetFormat, "Numbers of the k-buffer's targets", defaults.targetFormat,
           targetFormats());
  add(command, kGroup, "--early-termination", options.earlyTermination, "OPACITY",
      "Opacity at which a pixel is done (default: never)");
  command
      .add_flag("--composite-late", options.compositeLate,
                "Composite misordered fragments as the paper does, instead of dropping them")
      ->group(kGroup);
  command.add_flag("--paper", options.paper, "The paper's own choices; further options change them")->group(kGroup);
  add(command, kGroup, "--threads", options.threads, "N", "Threads (default: all cores)");
  add(command, kGroup, "--repeat", options.repeat, "N", "Draw N times and report medians (default 1)");
}

std::string known(const char* option, const std::string& name, const std::vector<std::string>& names) {
  if (std::find(names.begin(), names.end(), name) == names.end())
    failInput(fmt::format("unknown name '{}'", name), option, didYouMean(name, names));
  return name;
}

void refusePictureBeyondMemory(const Scene& scene) {
  needMemory(4.0 * sizeof(float) * scene.width * scene.height,
             fmt::format("a picture of {} x {}", scene.width, scene.height), "--size", "make it smaller");
}

void setSize(Scene& scene, const std::string& text) {
  const char* const end = text.data() + text.size();
  const auto [cross, error] = std::from_chars(text.data(), end, scene.width);
  const bool firstRead = error == std::errc{} && cross != end && *cross == 'x';
  const auto [last, secondError] = std::from_chars(firstRead ? cross + 1 : end, end, scene.height);
  if (!firstRead || secondError != std::errc{} || last != end)
    failInput(fmt::format("'{}' is not a size", text), "--size", "write WIDTHxHEIGHT, such as 1024x768");
}

std::array<double, 2> parseDomain(const std::string& text) {
  std::array<double, 2> domain{};
  const char* const end = text.data() + text.size();
  const auto [comma, error] = std::from_chars(text.data(), end, domain[0]);
  const bool firstRead = error == std::errc{} && comma != end && *comma == ',';
  const auto [last, secondError] = std::from_chars(firstRead ? comma + 1 : end, end, domain[1]);
  if (!firstRead || secondError != std::errc{} || last != end)
    failInput(fmt::format("'{}' is not a range of values", text), "--domain", "write LOW,HIGH, such as 0,1.5");
  return domain;
}

/// The option wins over the camera's own projection.
void setCamera(Scene& scene, const SceneOptions& options) {
  if (options.camera) scene.camera = parseCamera(*options.camera, Projection::perspective);
  if (!options.projection) return;
  const std::string name = known("--projection", *options.projection, kProjections);
  scene.camera.projection = name == "orthographic" ? Projection::orthographic : Projection::perspective;
}

void setK(Scene& scene, const std::string& text) {
  scene.kAuto = text == "auto";
  if (scene.kAuto) return;
  const char* const end = text.data() + text.size();
  const auto [last, error] = std::from_chars(text.data(), end, scene.k);
  if (error != std::errc{} || last != end)
    failInput(fmt::format("'{}' is no number of entries", text), "--k", "write a number, or auto");
}

/// Whether the native device, the fastest where there is no GPU, draws with the scene's settings.
bool nativeDraws(const Scene& scene) {
  const Mode& shown = mode(scene.mode);
  if (shown.gathering != Gathering::composite) return shown.native.make != nullptr;
  return visibilityMethod(scene.visibility).native.make != nullptr && scene.targetFormat == Scene{}.targetFormat;
}

void setMethod(Scene& scene, const SceneOptions& options) {
  if (options.visibility) scene.visibility = *options.visibility;
  if (options.sort) scene.sort = known("--sort", *options.sort, namesOf(sortMethods()));
  if (options.lookup) {
    scene.lookup = *options.lookup;
  } else if (!options.paper && !options.tableSize && !options.tableFormat) {
    scene.lookup = kAutoLookup;
  }
  if (options.instructionSet)
    scene.instructionSet = known("--simd", *options.instructionSet, namesOf(instructionSets()));
  if (options.tableFormat) scene.tableFormat = *options.tableFormat;
  if (options.targetFormat) scene.targetFormat = *options.targetFormat;
  if (options.device) {
    scene.device = known("--device", *options.device, namesOf(renderDevices()));
  } else if (nativeDraws(scene)) {
    scene.device = kNativeDevice;
  }
  if (options.k) setK(scene, *options.k);
  if (options.tableSize) scene.tableSize = *options.tableSize;
  if (options.earlyTermination) scene.earlyTermination = *options.earlyTermination;
  if (options.compositeLate) scene.compositeLate = true;
  if (options.repeat) scene.repeat = *options.repeat;
  if (options.threads) {
    constexpr int kMostThreads = 1024;  // oneTBB starts as many as it is told, each with a stack
    if (*options.threads < 0 || *options.threads > kMostThreads)
      failInput(fmt::format("{} is no number of threads from 0 to {}", *options.threads, kMostThreads), "--threads",
                "0 means all cores");
    scene.threads = static_cast<std::size_t>(*options.threads);
  }
}

}  // namespace

void addSceneOptions(CLI::App& command, SceneOptions& options) {
  addInputOptions(command, options);
  addClipOptions(command, options);
  addLightOptions(command, options);
  addTransferOptions(command, options);
  addIsosurfaceOptions(command, options);
  addOverlayOptions(command, options);
  addPictureOptions(command, options);
  addMethodOptions(command, options);
}

Scene makeScene(const SceneOptions& options) {
  Scene scene;
  if (options.paper) applyPaperPreset(scene);
  scene.mesh = options.mesh;
  scene.plot3dSolution = options.plot3dSolution;
  if (options.tetgenSwitches) scene.tetgenSwitches = *options.tetgenSwitches;
  if (options.field) scene.field = *options.field;
  if (options.transferFunction) scene.transferFunction = *options.transferFunction;
  scene.unitLength = options.unitLength;
  if (options.domain) scene.domain = parseDomain(*options.domain);
  if (options.mode) scene.mode = known("--mode", *options.mode, namesOf(modes()));
  if (options.size) setSize(scene, *options.size);
  if (options.background) scene.background = parseBackground(*options.background);
  setIsosurfaces(scene, options);
  setOverlays(scene, options);
  setClipping(scene, options);
  setLight(scene, options);
  setCamera(scene, options);
  setMethod(scene, options);
  checkScene(scene);
  if (options.maxMemory) limitMemory(parseMemorySize(*options.maxMemory, kMaxMemoryOption));
  refusePictureBeyondMemory(scene);
  return scene;
}

}  // namespace havs
