// What a frame of every mode costs beside the volume's, taken in turn on each device, with the same camera; prints
// JSON: medians of wall and processor milliseconds, and their ratios to the volume's.
#include <CLI/CLI.hpp>
#include <chrono>
#include <iostream>
#include <map>
#include <nlohmann/json.hpp>

#include "bench_mesh.h"
#include "core/error.h"
#include "core/median.h"
#include "core/memory.h"
#include "render/devices.h"
#include "render/make_renderer.h"
#include "render/modes.h"
#include "scene/prepared_scene.h"

namespace havs {
namespace {

struct Options {
  std::string mesh = HAVS_MESHES "/cube.poly";
  std::string switches = "pqa1.9e-6";
  std::string transferFunction = "rainbow";
  std::vector<std::string> devices{"native", "osmesa"};
  int size = 1024;
  int repeat = 5;
};

struct Times {
  std::vector<double> wall, cpu;
};

void drawTimed(Renderer& renderer, const View& view, Times& times) {
  StageTimes stages;
  const double cpu = cpuSeconds();
  const auto start = std::chrono::steady_clock::now();
  renderer.draw(view, stages);
  times.wall.push_back(std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count());
  times.cpu.push_back(1e3 * (cpuSeconds() - cpu));
}

nlohmann::ordered_json measure(const Options& options, const PreparedScene& prepared, Scene scene,
                               const std::string& deviceName) {
  scene.device = deviceName;
  const RenderDevice device = openRenderDevice(deviceName, scene.threads);
  const View view = viewOf(scene, prepared);
  std::map<std::string, std::unique_ptr<Renderer>> renderers;
  std::map<std::string, Times> times;
  for (const Mode& row : modes()) {
    if (!row.seesVolume) continue;  // isosurfaces: the scene has none
    scene.mode = row.name;
    StageTimes stages;
    renderers[row.name] = makeRenderer(prepared, plan(scene, prepared.facts(), device.capabilities), stages);
    renderers[row.name]->draw(view, stages);  // to warm up
  }
  for (int i = 0; i < options.repeat; ++i)
    for (const auto& [name, renderer] : renderers) drawTimed(*renderer, view, times[name]);
  nlohmann::ordered_json json;
  const Times& volume = times.at("volume");
  for (const auto& [name, taken] : times)
    json[name] = {{"wall_ms", medianOf(taken.wall)},
                  {"cpu_ms", medianOf(taken.cpu)},
                  {"wall_ratio", medianOf(taken.wall) / medianOf(volume.wall)},
                  {"cpu_ratio", medianOf(taken.cpu) / medianOf(volume.cpu)}};
  return json;
}

nlohmann::ordered_json measure(const Options& options) {
  Scene scene;
  scene.transferFunction = options.transferFunction;
  scene.width = scene.height = options.size;
  scene.k = 6;
  StageTimes stages;
  const PreparedScene prepared = prepareScene(scene, benchMesh(options.mesh, options.switches), stages);
  nlohmann::ordered_json json{{"tetrahedra", prepared.mesh.tetrahedra.size()},
                              {"size", options.size},
                              {"transfer_function", options.transferFunction},
                              {"repeat", options.repeat}};
  for (const std::string& device : options.devices) json[device] = measure(options, prepared, scene, device);
  return json;
}

}  // namespace
}  // namespace havs

int main(int argc, char** argv) {
  havs::Options options;
  CLI::App app("What a frame of every mode costs beside the volume's; prints JSON");
  app.add_option("--mesh", options.mesh, "any mesh, or a surface for TetGen")->capture_default_str();
  app.add_option("--tetgen", options.switches, "TetGen's switches")->capture_default_str();
  app.add_option("--tf", options.transferFunction, "transfer function")->capture_default_str();
  app.add_option("--device", options.devices, "devices")->capture_default_str();
  app.add_option("--size", options.size, "pixels along each side")->capture_default_str();
  app.add_option("--repeat", options.repeat, "counted frames of each mode")->capture_default_str();
  CLI11_PARSE(app, argc, argv);
  try {
    std::cout << havs::measure(options).dump(2) << '\n';
  } catch (const havs::Error& error) {
    std::cerr << "bench_modes: " << error.what() << '\n';
    return error.exitStatus();
  }
}
