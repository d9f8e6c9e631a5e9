#include "app/scene_options.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>

#include "app/table_names.h"
#include "core/error.h"
#include "core/nearest_name.h"
#include "gl/device.h"
#include "scene/methods.h"
#include "scene/plan.h"
#include "sort/face_order.h"
#include "transfer/transfer_function.h"

namespace havs {
namespace {

const std::vector<std::string> kProjections{"perspective", "orthographic"};

void addInputOptions(CLI::App& command, SceneOptions& options) {
  command.add_option("INPUT", options.mesh, "Mesh: " + meshExtensions())->required();
  const std::string group = "Mesh and field";
  command
      .add_option("--field", options.field,
                  "NAME, NAME:x, NAME:2, NAME:magnitude, point:NAME, cell:NAME (default: the first)")
      ->group(group);
  command.add_option("--q", options.plot3dSolution, "PLOT3D solution file (default: found beside the grid)")
      ->group(group);
  command.add_option("--tetgen", options.tetgenSwitches, "TetGen's switches for a surface")->group(group);
}

void addTransferOptions(CLI::App& command, SceneOptions& options) {
  const std::string group = "Transfer function";
  command
      .add_option("--tf", options.transferFunction,
                  fmt::format("File (JSON, ParaView's JSON or XML, TF.bin) or preset (default {}):{}",
                              Scene{}.transferFunction, rowsForHelp(transferPresets())))
      ->group(group);
  command.add_option("--unit-length", options.unitLength, "Length that opacity is meant for, in mesh units")
      ->group(group);
  command.add_option("--domain", options.domain, "LO,HI: data values of the transfer function's ends")->group(group);
}

void addPictureOptions(CLI::App& command, SceneOptions& options) {
  const std::string group = "Camera and picture";
  command.add_option("--size", options.size, "WIDTHxHEIGHT in pixels (default 1024x1024)")->group(group);
  command.add_option("--camera", options.camera, "AZIMUTH,ELEVATION[,ZOOM], a JSON object, or a file with one")
      ->group(group);
  command.add_option("--projection", options.projection, "perspective (default) or orthographic")->group(group);
  command.add_option("--background", options.background, "white (default), black, none, '#rrggbb' or r,g,b")
      ->group(group);
}

void addMethodOptions(CLI::App& command, SceneOptions& options) {
  const std::string group = "Method";
  const Scene defaults;
  command.add_option("--k", options.k, fmt::format("Entries of the k-buffer (default {})", defaults.k))->group(group);
  auto addTable = [&](const char* name, std::optional<std::string>& value, const char* what, const std::string& chosen,
                      const auto& rows) {
    command.add_option(name, value, fmt::format("{} (default {}):{}", what, chosen, rowsForHelp(rows)))->group(group);
  };
  addTable("--visibility", options.visibility, "How fragments are put in order", defaults.visibility,
           visibilityMethods());
  addTable("--sort", options.sort, "Order in which faces are drawn", defaults.sort, sortMethods());
  addTable("--lookup", options.lookup, "How a segment's colour is found", defaults.lookup, lookups());
  command
      .add_option("--table", options.tableSize,
                  fmt::format("Entries along each axis of the table (default {})", defaults.tableSize))
      ->group(group);
  addTable("--table-format", options.tableFormat, "Numbers of the table", defaults.tableFormat, tableFormats());
  command
      .add_option("--early-termination", options.earlyTermination, "Opacity at which a pixel is done (default: never)")
      ->group(group);
  command
      .add_flag("--composite-late", options.compositeLate,
                "Composite misordered fragments as the paper does, instead of dropping them")
      ->group(group);
  command.add_flag("--paper", options.paper, "The paper's own choices; other options still count")->group(group);
  addTable("--device", options.device, "Where to draw", defaults.device, deviceRows());
  command.add_option("--threads", options.threads, "Threads (default: all cores)")->group(group);
  command.add_option("--repeat", options.repeat, "Draw so many times and report medians")->group(group);
}

std::string known(const char* option, const std::string& name, const std::vector<std::string>& names) {
  if (std::find(names.begin(), names.end(), name) == names.end())
    failInput(fmt::format("unknown name '{}'", name), option, didYouMean(name, names));
  return name;
}

void refusePictureBeyondMemory(const Scene& scene) {
  const double needed = 4.0 * sizeof(float) * scene.width * scene.height;
  const double available = static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE));
  if (needed > available)
    failInput(fmt::format("a picture of {} x {} needs {:.1f} GB, this machine has {:.1f} GB", scene.width, scene.height,
                          needed / 1e9, available / 1e9),
              "--size", "make it smaller");
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

void setCamera(Scene& scene, const SceneOptions& options) {
  const std::string name = known("--projection", options.projection, kProjections);
  const Projection projection = name == "orthographic" ? Projection::orthographic : Projection::perspective;
  if (options.camera)
    scene.camera = parseCamera(*options.camera, projection);
  else
    scene.camera.projection = projection;
}

void setMethod(Scene& scene, const SceneOptions& options) {
  if (options.visibility) scene.visibility = *options.visibility;
  if (options.sort) scene.sort = known("--sort", *options.sort, namesOf(sortMethods()));
  if (options.lookup) scene.lookup = *options.lookup;
  if (options.device) scene.device = known("--device", *options.device, namesOf(deviceRows()));
  if (options.tableFormat) scene.tableFormat = *options.tableFormat;
  if (options.k) scene.k = *options.k;
  if (options.tableSize) scene.tableSize = *options.tableSize;
  if (options.earlyTermination) scene.earlyTermination = *options.earlyTermination;
  if (options.compositeLate) scene.compositeLate = true;
  if (options.repeat) scene.repeat = *options.repeat;
  if (options.threads) {
    if (*options.threads < 0)
      failInput(fmt::format("{} is no number of threads", *options.threads), "--threads", "0 means all cores");
    scene.threads = static_cast<std::size_t>(*options.threads);
  }
}

}  // namespace

void addSceneOptions(CLI::App& command, SceneOptions& options) {
  addInputOptions(command, options);
  addTransferOptions(command, options);
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
  if (options.size) setSize(scene, *options.size);
  if (options.background) scene.background = parseBackground(*options.background);
  setCamera(scene, options);
  setMethod(scene, options);
  checkScene(scene);
  refusePictureBeyondMemory(scene);
  return scene;
}

}  // namespace havs
