// What leaving out the cells that show nothing gives, for each transfer function: time to find the visible part, frames
// of the whole mesh against frames of the part, in turn in one run (wall and processor time, medians after a warm-up),
// late fragments of both at each k, and how far apart the pictures are. Prints JSON.
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
#include "scene/visible_part.h"

namespace havs {
namespace {

struct Options {
  std::string mesh = HAVS_MESHES "/cube.poly";
  std::string switches = "pqa1.9e-6";
  std::string field;
  std::vector<std::string> transferFunctions{"three-peaks", "shells", "plateau-opaque"};
  std::vector<int> ks{1, 2, 6};
  std::string visibility = Scene{}.visibility;
  std::string lookup = "exact";
  int size = 1024;
  int repeat = 5;
};

struct Times {
  std::vector<double> wall, cpu;
  template <class Work>
  void time(const Work& work) {
    const double cpuBefore = cpuSeconds();
    const auto start = std::chrono::steady_clock::now();
    work();
    wall.push_back(std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count());
    cpu.push_back(1e3 * (cpuSeconds() - cpuBefore));
  }
  nlohmann::ordered_json json() const { return {{"wall_ms", medianOf(wall)}, {"cpu_ms", medianOf(cpu)}}; }
};

double greatestDifference(const Image& a, const Image& b) {
  double greatest = 0;
  for (std::size_t i = 0; i < a.rgba.size(); ++i)
    greatest = std::max<double>(greatest, std::abs(a.rgba[i] - b.rgba[i]));
  return greatest;
}

std::size_t pixelsBeyond(const Image& a, const Image& b, double limit) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < a.rgba.size(); i += 4) {
    bool beyond = false;
    for (std::size_t c = i; c < i + 4; ++c) beyond = beyond || std::abs(a.rgba[c] - b.rgba[c]) > limit;
    count += beyond ? 1 : 0;
  }
  return count;
}

/// Late fragments of the whole mesh, of the part's own order and of what is drawn in the end.
nlohmann::ordered_json certificates(Scene scene, const PreparedScene& whole, const View& view, const Device& device,
                                    const std::vector<int>& ks) {
  nlohmann::ordered_json rows = nlohmann::json::array();
  scene.certificate = true;
  for (const int k : ks) {
    scene.k = k;
    StageTimes ignored;
    const RenderPlan chosen = plan(scene, whole.facts(), capabilitiesOf(device));
    const Drawing all = chosen.way.make(whole, chosen, ignored, {})->draw(view, ignored);
    const Drawing part = makeRenderer(whole, chosen, ignored)->draw(view, ignored);
    rows.push_back({{"k", k},
                    {"whole", all.certificate->misordered},
                    {"part", part.certificate->misordered},
                    {"fragments_of_whole", all.certificate->fragments},
                    {"fragments_of_part", part.certificate->fragments},
                    {"greatest_difference", greatestDifference(all.image, part.image)},
                    {"pixels_beyond_1e-6", pixelsBeyond(all.image, part.image, 1e-6)}});
  }
  return rows;
}

nlohmann::ordered_json measure(const Options& options, const std::string& transferFunction, const TetMesh& mesh,
                               const Device& device) {
  Scene scene;
  scene.field = options.field;
  scene.transferFunction = transferFunction;
  scene.visibility = options.visibility;
  scene.lookup = options.lookup;
  scene.width = scene.height = options.size;
  StageTimes stages;
  const PreparedScene whole = prepareScene(scene, mesh, stages);
  const View view = viewOf(scene, whole);
  const RenderPlan chosen = plan(scene, whole.facts(), capabilitiesOf(device));
  const auto all = chosen.way.make(whole, chosen, stages, {});
  const auto visible = makeRenderer(whole, chosen, stages);
  all->draw(view, stages);
  const Drawing first = visible->draw(view, stages);
  Times finding, ofAll, ofVisible;
  StageTimes stagesOfAll, stagesOfVisible;
  for (int i = 0; i < options.repeat; ++i) {
    finding.time([&] { static_cast<void>(visiblePart(whole)); });
    ofAll.time([&] { all->draw(view, stagesOfAll); });
    ofVisible.time([&] { visible->draw(view, stagesOfVisible); });
  }
  nlohmann::ordered_json json;
  json["transfer_function"] = transferFunction;
  json["cells"] = whole.mesh.tetrahedra.size();
  json["drawn_cells"] = first.drawnCells.value_or(whole.mesh.tetrahedra.size());
  json["find_visible_part"] = finding.json();
  json["frame_of_all"] = ofAll.json();
  json["frame_of_visible"] = ofVisible.json();
  for (const auto& [stage, ms] : stagesOfVisible.medians()) json["stages_of_visible_ms"][stage] = ms;
  json["ratio_wall"] = medianOf(ofAll.wall) / medianOf(ofVisible.wall);
  json["ratio_cpu"] = medianOf(ofAll.cpu) / medianOf(ofVisible.cpu);
  json["orders"] = certificates(scene, whole, view, device, options.ks);
  return json;
}

}  // namespace
}  // namespace havs

int main(int argc, char** argv) {
  havs::Options options;
  CLI::App app("What leaving out the cells that show nothing gives; prints JSON");
  app.add_option("--mesh", options.mesh, "a mesh, or a surface for TetGen")->capture_default_str();
  app.add_option("--tetgen", options.switches, "TetGen's switches")->capture_default_str();
  app.add_option("--field", options.field, "a field of the mesh; default an expression");
  app.add_option("--tf", options.transferFunctions, "transfer functions")->capture_default_str();
  app.add_option("--k", options.ks, "entries of the k-buffer, for the count of late fragments")->capture_default_str();
  app.add_option("--visibility", options.visibility, "visibility method")->capture_default_str();
  app.add_option("--lookup", options.lookup, "how a segment's colour is found")->capture_default_str();
  app.add_option("--size", options.size, "pixels along each side")->capture_default_str();
  app.add_option("--repeat", options.repeat, "counted frames")->capture_default_str();
  CLI11_PARSE(app, argc, argv);
  try {
    const havs::TetMesh mesh = havs::benchMesh(options.mesh, options.switches);
    const auto device = havs::makeDevice(havs::Scene{}.device);
    nlohmann::ordered_json json = nlohmann::json::array();
    for (const std::string& name : options.transferFunctions)
      json.push_back(havs::measure(options, name, mesh, *device));
    std::cout << json.dump(2) << '\n';
  } catch (const havs::Error& error) {
    std::cerr << "bench_visible: " << error.what() << '\n';
    return error.exitStatus();
  }
}
