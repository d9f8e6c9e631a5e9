// What a frame costs, the read-back of its pixels included, with the camera still and with the camera turned by a
// degree from frame to frame, so that nothing kept from the frame before serves the next. Takes the options of havs
// render; each way is warmed up by a frame that is not counted. Prints JSON: wall and processor time of every frame.
#include <CLI/CLI.hpp>
#include <chrono>
#include <cmath>
#include <iostream>
#include <nlohmann/json.hpp>
#include <numbers>

#include "app/scene_options.h"
#include "core/error.h"
#include "core/memory.h"
#include "core/parallel.h"
#include "render/devices.h"
#include "render/make_renderer.h"

namespace havs {
namespace {

struct Options {
  SceneOptions scene;
  int frames = 5;
  double degrees = 1;
  std::string output;
};

/// The view turned about the mesh's centre and the camera's up, as vtkCamera::Azimuth turns it.
View turned(View view, double degrees) {
  const double angle = degrees * std::numbers::pi / 180.0;
  const Vec3 axis = view.up;
  auto turn = [&](const Vec3& v) {  // Rodrigues
    return v * std::cos(angle) + cross(axis, v) * std::sin(angle) + axis * (dot(axis, v) * (1.0 - std::cos(angle)));
  };
  view.eye = turn(view.eye);
  view.center = turn(view.center);
  view.forward = turn(view.forward);
  view.right = turn(view.right);
  return view;
}

/// Times of frames, and the median of each stage in them.
struct Frames {
  std::vector<double> wall, cpu;  ///< milliseconds
  StageTimes stages;
};

/// Draws once uncounted at turn 0, then `frames` times, each a step further. The last picture.
Image drawFrames(Renderer& renderer, const View& view, int frames, double degrees, Frames& times) {
  StageTimes warmUp;
  renderer.draw(view, warmUp);
  Image last;
  for (int i = 1; i <= frames; ++i) {
    const View seen = turned(view, i * degrees);
    const double cpu = cpuSeconds();
    const auto start = std::chrono::steady_clock::now();
    last = renderer.draw(seen, times.stages).image;
    times.wall.push_back(std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count());
    times.cpu.push_back(1e3 * (cpuSeconds() - cpu));
  }
  return last;
}

nlohmann::ordered_json asJson(const Frames& frames) {
  nlohmann::ordered_json stages = nlohmann::ordered_json::object();
  for (const auto& [stage, milliseconds] : frames.stages.medians()) stages[stage] = milliseconds;
  return {{"wall_ms", frames.wall}, {"cpu_ms", frames.cpu}, {"stages_ms", stages}};
}

nlohmann::ordered_json measure(const Options& options) {
  const Scene scene = makeScene(options.scene);
  if (!options.output.empty()) checkImagePath(options.output);
  const ThreadLimit limit(scene.threads);
  StageTimes stages;
  const PreparedScene prepared = prepareScene(scene, stages);
  const View view = viewOf(scene, prepared);
  const RenderDevice device = openRenderDevice(scene.device, scene.threads);
  const RenderPlan chosen = plan(scene, prepared.facts(), device.capabilities);
  const auto renderer = makeRenderer(prepared, chosen, stages);

  Frames still, turning;
  const Image picture = drawFrames(*renderer, view, options.frames, 0, still);
  if (!options.output.empty()) writeImage(picture, options.output, {scene.background, 8});
  drawFrames(*renderer, view, options.frames, options.degrees, turning);

  nlohmann::ordered_json json;
  json["renderer"] = device.renderer;
  json["threads"] = threadCount();
  json["tetrahedra"] = prepared.mesh.tetrahedra.size();
  json["faces"] = prepared.faces.size();
  json["lookup"] = chosen.lookup.name;
  json["k"] = chosen.k;
  json["still"] = asJson(still);
  json["turning"] = asJson(turning);
  json["peak_memory_bytes"] = peakMemoryBytes();
  return json;
}

}  // namespace
}  // namespace havs

int main(int argc, char** argv) {
  havs::Options options;
  CLI::App app("What a frame costs, camera still and turning; prints JSON");
  havs::addSceneOptions(app, options.scene);
  app.add_option("--frames", options.frames, "counted frames, still and turning")->capture_default_str();
  app.add_option("--degrees", options.degrees, "turn from frame to frame")->capture_default_str();
  app.add_option("-o,--output", options.output, "the picture of the camera standing still");
  CLI11_PARSE(app, argc, argv);
  try {
    std::cout << havs::measure(options).dump(2) << '\n';
  } catch (const havs::Error& error) {
    std::cerr << "bench_turn: " << error.what() << '\n';
    return error.exitStatus();
  }
}
