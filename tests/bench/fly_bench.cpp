// A flight through a mesh, from outside through three of its cells and out again: each frame against the reference,
// and what cutting the mesh before the eye costs. Takes the options of havs render but for the camera. Prints JSON.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <iostream>
#include <nlohmann/json.hpp>

#include "app/scene_options.h"
#include "core/error.h"
#include "image/compare.h"
#include "mesh/read.h"
#include "mesh/scalar_field.h"
#include "reference/edge_mask.h"
#include "reference/reference_renderer.h"
#include "render/devices.h"
#include "render/make_renderer.h"
#include "scene/eye_cut.h"
#include "support/fly_path.h"

namespace havs {
namespace {

struct Options {
  SceneOptions scene;
  std::string expression;
  int frames = 60;
  double fieldOfView = 60;
  bool withTruth = true;
  std::string folder;
};

double millisecondsOf(const std::function<void()>& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

PreparedScene prepare(const Options& options, const Scene& scene) {
  TetMesh mesh = readMesh(scene.mesh, {.plot3dSolution = scene.plot3dSolution, .tetgenSwitches = scene.tetgenSwitches});
  if (!options.expression.empty()) mesh.pointFields = {fieldFromExpression(mesh, "s", options.expression)};
  StageTimes stages;
  return prepareScene(scene, std::move(mesh), stages);
}

nlohmann::ordered_json measure(const Options& options) {
  Scene scene = makeScene(options.scene);
  const PreparedScene prepared = prepare(options, scene);
  const RenderDevice device = openRenderDevice(scene.device, scene.threads);
  const RenderPlan chosen = plan(scene, prepared.facts(), device.capabilities);
  StageTimes ignored;
  const auto renderer = makeRenderer(prepared, chosen, ignored);
  const auto reference = makeReferenceRenderer(prepared);
  nlohmann::ordered_json json;
  json["tetrahedra"] = prepared.mesh.tetrahedra.size();
  json["lookup"] = chosen.lookup.name;
  double worstRmse = 0, worstP999 = 0, worst = 0;
  for (int i = 0; const Camera& camera : test::flyPath(prepared, options.frames, options.fieldOfView)) {
    scene.camera = camera;
    const View view = viewOf(scene, prepared);
    nlohmann::ordered_json row;
    row["frame"] = i;
    row["camera"] = nlohmann::ordered_json::parse(describe(camera, prepared.frame, scene.width, scene.height));
    row["cut"] = needsEyeCut(prepared, view, chosen.native ? kEyeCutInDouble : kEyeCutInFloat);
    StageTimes stages;
    Drawing drawing;
    row["ms"] = millisecondsOf([&] { drawing = renderer->draw(view, stages); });
    row["again_ms"] = millisecondsOf([&] { renderer->draw(view, ignored); });
    row["eye_cut_ms"] = stages.total("eye_cut");
    row["cells"] = drawing.drawnCells.value_or(prepared.mesh.tetrahedra.size());
    if (options.withTruth) {
      const Image truth = reference->draw(view, ignored).image;
      const auto mask = boundaryEdgeMask(prepared.points, prepared.faces, view);
      const auto all = compareImages(drawing.image, truth).rgba,
                 outside = compareImages(drawing.image, truth, mask).rgba;
      row["rmse"] = all.rmse;
      row["max"] = all.max;
      row["p999_outside"] = outside.p999;
      row["rmse_outside"] = outside.rmse;
      worstRmse = std::max(worstRmse, all.rmse);
      worst = std::max(worst, all.max);
      worstP999 = std::max(worstP999, outside.p999);
    }
    if (!options.folder.empty())
      writeImage(drawing.image, fmt::format("{}/frame{:03}.png", options.folder, i), {scene.background, 8});
    json["frames"].push_back(row);
    ++i;
  }
  json["worst"] = {{"rmse", worstRmse}, {"p999_outside", worstP999}, {"max", worst}};
  return json;
}

}  // namespace
}  // namespace havs

int main(int argc, char** argv) {
  havs::Options options;
  CLI::App app("A flight through a mesh against the reference; prints JSON");
  havs::addSceneOptions(app, options.scene);
  app.add_option("--frames", options.frames, "cameras on the way")->capture_default_str();
  app.add_option("--fov", options.fieldOfView, "field of view in degrees")->capture_default_str();
  app.add_option("--expression", options.expression, "field of x, y and z instead of the mesh's");
  app.add_option("--truth", options.withTruth, "compare with the reference")->capture_default_str();
  app.add_option("--pictures", options.folder, "folder for a PNG of each frame");
  CLI11_PARSE(app, argc, argv);
  try {
    std::cout << havs::measure(options).dump(1) << '\n';
  } catch (const havs::Error& error) {
    std::cerr << "bench_fly: " << error.what() << '\n';
    return error.exitStatus();
  }
}
