// What a change of the shaders costs or saves: frames of one scene by several folders of shaders (as HAVS_SHADERS takes
// them), in turn in one process after a warm-up; processor time of a frame, its median and least, against the first
// folder's, and the greatest difference of the pictures. "-": the shaders of the program. Prints JSON.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdlib>
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
  std::vector<std::string> shaders{"-"};
  Scene scene;
  int size = 1024;
  int repeat = 9;
};

struct Variant {
  std::string name;
  std::unique_ptr<Renderer> renderer;
  std::vector<double> cpu;
  StageTimes stages;
  Image image;
};

double greatestDifference(const Image& a, const Image& b) {
  double greatest = 0;
  for (std::size_t i = 0; i < a.rgba.size(); ++i)
    greatest = std::max<double>(greatest, std::abs(a.rgba[i] - b.rgba[i]));
  return greatest;
}

nlohmann::ordered_json measure(Options options) {
  Scene& scene = options.scene;
  scene.width = scene.height = options.size;
  StageTimes stages;
  const PreparedScene prepared = prepareScene(scene, benchMesh(options.mesh, options.switches), stages);
  const View view = viewOf(scene, prepared);
  const auto device = makeDevice(scene.device);
  const RenderPlan chosen = plan(scene, prepared.facts(), capabilitiesOf(*device));
  std::vector<Variant> variants;
  for (const std::string& folder : options.shaders) {
    if (folder == "-") {
      unsetenv("HAVS_SHADERS");
    } else {
      setenv("HAVS_SHADERS", folder.c_str(), 1);
    }
    variants.push_back({folder, makeRenderer(prepared, chosen, stages), {}, {}, {}});
    variants.back().image = variants.back().renderer->draw(view, stages).image;
  }
  for (int i = 0; i < options.repeat; ++i)
    for (Variant& variant : variants) {
      const double before = cpuSeconds();
      variant.renderer->draw(view, variant.stages);
      variant.cpu.push_back(1e3 * (cpuSeconds() - before));
    }
  nlohmann::ordered_json json;
  json["tetrahedra"] = prepared.mesh.tetrahedra.size();
  json["lookup"] = scene.lookup;
  json["k"] = scene.k;
  json["size"] = options.size;
  for (const Variant& variant : variants) {
    const double least = *std::min_element(variant.cpu.begin(), variant.cpu.end());
    nlohmann::ordered_json row{{"shaders", variant.name}, {"cpu_ms", medianOf(variant.cpu)}, {"least_cpu_ms", least}};
    row["to_first"] = medianOf(variant.cpu) / medianOf(variants.front().cpu);
    for (const auto& [stage, ms] : variant.stages.medians()) row["stages_ms"][stage] = ms;
    row["greatest_difference"] = greatestDifference(variant.image, variants.front().image);
    json["variants"].push_back(row);
  }
  return json;
}

}  // namespace
}  // namespace havs

int main(int argc, char** argv) {
  havs::Options options;
  CLI::App app("What a change of the shaders costs or saves; prints JSON");
  app.add_option("--mesh", options.mesh, "a mesh, or a surface for TetGen")->capture_default_str();
  app.add_option("--tetgen", options.switches, "TetGen's switches")->capture_default_str();
  app.add_option("--shaders", options.shaders, "folders of shaders, - for the program's")->capture_default_str();
  app.add_option("--field", options.scene.field, "a field of the mesh; default an expression");
  app.add_option("--tf", options.scene.transferFunction, "transfer function")->capture_default_str();
  app.add_option("--lookup", options.scene.lookup, "how a segment's colour is found")->capture_default_str();
  app.add_option("--table", options.scene.tableSize, "entries along each axis of the table")->capture_default_str();
  app.add_option("--visibility", options.scene.visibility, "visibility method")->capture_default_str();
  app.add_option("--target-format", options.scene.targetFormat, "numbers of the targets")->capture_default_str();
  app.add_option("--k", options.scene.k, "entries of the k-buffer")->capture_default_str();
  app.add_option("--early-termination", options.scene.earlyTermination, "opacity at which a pixel is done");
  app.add_option("--size", options.size, "pixels along each side")->capture_default_str();
  app.add_option("--repeat", options.repeat, "counted frames")->capture_default_str();
  CLI11_PARSE(app, argc, argv);
  try {
    std::cout << havs::measure(options).dump(2) << '\n';
  } catch (const havs::Error& error) {
    std::cerr << "bench_variants: " << error.what() << '\n';
    return error.exitStatus();
  }
}
