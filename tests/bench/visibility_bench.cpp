// What a picture costs by each visibility method, on a mesh of about 200,000 tetrahedra: all methods in turn in each
// round, processor and wall time of a whole drawing (order, upload, draw, flush, read back), memory of targets and
// lists. The a-buffer besides with its faces in topological order, to see what sorted lists would save. Medians after a
// warm-up; prints JSON.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <iostream>
#include <nlohmann/json.hpp>

#include "bench_mesh.h"
#include "core/error.h"
#include "core/median.h"
#include "core/memory.h"
#include "mesh/read.h"
#include "mesh/scalar_field.h"
#include "render/make_renderer.h"

namespace havs {
namespace {

struct Options {
  std::string mesh = HAVS_MESHES "/cube.poly";
  std::string switches = "pqa1e-5";
  std::string field;
  std::string lookup = Scene{}.lookup;
  std::vector<int> sizes{512, 1024};
  int repeat = 5;
};

struct Run {
  std::string name;
  std::unique_ptr<Renderer> renderer;
  std::size_t bytesPerPixel;
  std::vector<double> cpu, wall;
  StageTimes stages;
  Drawing last;
};

void time(Run& run, const View& view) {
  const double cpu = cpuSeconds();
  const auto start = std::chrono::steady_clock::now();
  run.last = run.renderer->draw(view, run.stages);
  run.wall.push_back(std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count());
  run.cpu.push_back(1e3 * (cpuSeconds() - cpu));
}

/// The faces renumbered as the topological order of this view has them.
PreparedScene sorted(const PreparedScene& prepared, const View& view) {
  FaceOrder order;
  sortMethod("topological")
      .make({prepared.points, prepared.mesh.tetrahedra, &prepared.faces})
      ->sort(viewPointOf(view), order);
  PreparedScene result = prepared;
  for (std::size_t f = 0; f < order.faces.size(); ++f) {
    result.faces.vertices[f] = prepared.faces.vertices[order.faces[f]];
    result.faces.cells[f] = prepared.faces.cells[order.faces[f]];
  }
  return result;
}

nlohmann::ordered_json asJson(const Run& run, const View& view) {
  nlohmann::ordered_json json;
  json["method"] = run.name;
  json["cpu_ms"] = medianOf(run.cpu);
  json["wall_ms"] = medianOf(run.wall);
  for (const auto& [stage, milliseconds] : run.stages.medians()) json["stages_ms"][stage] = milliseconds;
  json["target_bytes"] =
      run.bytesPerPixel * static_cast<std::size_t>(view.width) * static_cast<std::size_t>(view.height);
  json["fragments"] = run.last.fragments;
  json["fragment_bytes"] = run.last.fragmentBytes;
  json["tiles"] = run.last.tiles;
  return json;
}

nlohmann::ordered_json measure(const Options& options) {
  TetMesh mesh = benchMesh(options.mesh, options.switches);
  Scene scene;
  scene.field = options.field;
  scene.lookup = options.lookup;
  StageTimes stages;
  const PreparedScene prepared = prepareScene(scene, std::move(mesh), stages);
  const auto device = makeDevice(scene.device);
  nlohmann::ordered_json json;
  json["tetrahedra"] = prepared.mesh.tetrahedra.size();
  json["faces"] = prepared.faces.size();
  json["renderer"] = device->renderer();
  for (const int size : options.sizes) {
    scene.width = scene.height = size;
    const View view = makeView(scene.camera, prepared.frame, size, size);
    const PreparedScene inOrder = sorted(prepared, view);
    std::vector<Run> runs;
    auto add = [&](const std::string& name, const std::string& method, const PreparedScene& data) {
      scene.visibility = method;
      const RenderPlan chosen = plan(scene, data.facts(), capabilitiesOf(*device));
      runs.push_back({name, makeRenderer(data, chosen, stages), static_cast<std::size_t>(chosen.bytesPerPixel)});
    };
    for (const VisibilityMethod& method : visibilityMethods()) add(method.name, method.name, prepared);
    add("abuffer, faces in order", "abuffer", inOrder);
    for (Run& run : runs) run.renderer->draw(view, stages);
    for (int i = 0; i < options.repeat; ++i)
      for (Run& run : runs) time(run, view);
    for (const Run& run : runs) json["pictures"][std::to_string(size)].push_back(asJson(run, view));
  }
  return json;
}

}  // namespace
}  // namespace havs

int main(int argc, char** argv) {
  havs::Options options;
  CLI::App app("What a picture costs by each visibility method; prints JSON");
  app.add_option("--mesh", options.mesh, "a mesh, or a surface for TetGen")->capture_default_str();
  app.add_option("--tetgen", options.switches, "TetGen's switches")->capture_default_str();
  app.add_option("--field", options.field, "a field of the mesh");
  app.add_option("--lookup", options.lookup, "how a segment's colour is found")->capture_default_str();
  app.add_option("--size", options.sizes, "pixels along each side")->capture_default_str();
  app.add_option("--repeat", options.repeat, "counted pictures")->capture_default_str();
  CLI11_PARSE(app, argc, argv);
  try {
    std::cout << havs::measure(options).dump(2) << '\n';
  } catch (const havs::Error& error) {
    std::cerr << "bench_visibility: " << error.what() << '\n';
    return error.exitStatus();
  }
}
