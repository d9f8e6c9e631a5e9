#include "app/picture_options.h"

#include <fmt/core.h>

#include <set>

#include "app/limit_threads.h"
#include "app/print_json.h"
#include "app/render_report.h"
#include "app/scene_file.h"
#include "app/scene_views.h"
#include "core/error.h"
#include "core/memory_budget.h"
#include "core/output_file.h"
#include "image/image.h"

namespace havs {

void addPictureOptions(CLI::App& command, PictureOptions& options) {
  addSceneOptions(command, options.scene);
  CLI::Option* input = command.get_option("INPUT");
  input->description("A scene file (.json), or a mesh: " + input->get_description().substr(6));
  command
      .add_option("--set", options.changes,
                  "Change a value of the scene file: k=4, camera.azimuth=30; may be given several times")
      ->type_name("KEY=VALUE")
      ->take_all()
      ->expected(1);
  command.add_option("--save-scene", options.savedScene, "Write what this command line says as a scene file")
      ->type_name("FILE")
      ->group(kOutputGroup);
  command.add_option("-o,--output", options.outputs, "Picture: .png, .exr or .pfm; may be given several times")
      ->type_name("FILE")
      ->take_all()
      ->expected(1)
      ->group(kOutputGroup);
  command.add_option("--png-bits", options.pngBits, "Bits a channel: 8 (default) or 16")
      ->type_name("N")
      ->group(kOutputGroup);
  command.add_flag("--json", options.json, "Report all that is known, as JSON")->group(kOutputGroup);
  command.add_flag("--quiet", options.quiet, "Print nothing but errors (and what --json asks for)")
      ->group(kOutputGroup);
}

void readSceneFile(PictureOptions& options) {
  if (isSceneFile(options.scene.mesh)) {
    readSceneFile(options.scene, options.outputs, options.changes);
  } else if (!options.changes.empty()) {
    failInput("changes scene files, and INPUT is none", "--set", "use the options themselves");
  }
}

std::vector<AskedPicture> askedPictures(const PictureOptions& options) {
  if (options.pngBits != 8 && options.pngBits != 16)
    failInput(fmt::format("must be 8 or 16, not {}", options.pngBits), "--png-bits");
  if (!options.outputs.empty()) refuseViews(options.scene, "--output");
  if (!options.savedScene.empty()) {
    const OutputFile probe(options.savedScene);
  }
  std::vector<AskedPicture> pictures;
  for (const SceneOptions& view : optionsOfViews(options.scene)) pictures.push_back({makeScene(view), options.outputs});
  for (std::size_t i = 0; i < options.scene.views.size() && options.outputs.empty(); ++i)
    pictures[i].outputs = options.scene.views[i].outputs;
  limitThreads(pictures.front().scene.threads);
  std::set<std::filesystem::path> all;
  for (const AskedPicture& picture : pictures)
    for (const auto& output : picture.outputs) {
      checkImagePath(output);
      if (!all.insert(std::filesystem::absolute(output).lexically_normal()).second)
        failInput("is named twice as a picture to write", output.string(), "one would overwrite the other");
    }
  double bytes = 0;
  for (const AskedPicture& picture : pictures)
    bytes += 4.0 * sizeof(float) * picture.scene.width * picture.scene.height;
  needMemory(bytes, fmt::format("the {} pictures", pictures.size()), "views", "draw fewer at once");
  return pictures;
}

std::vector<Scene> scenesOf(std::span<const AskedPicture> pictures) {
  std::vector<Scene> scenes;
  for (const AskedPicture& picture : pictures) scenes.push_back(picture.scene);
  return scenes;
}

namespace {

/// All before anything is printed: who reads what is printed may stop to (SIGPIPE).
void writeFiles(const PictureOptions& options, std::span<const AskedPicture> pictures,
                std::span<const RenderReport> reports) {
  try {
    if (!options.savedScene.empty()) {
      OutputFile file(options.savedScene);
      file.write(sceneFileOf(options.scene, options.outputs, options.savedScene));
      file.commit();
    }
    for (std::size_t i = 0; i < pictures.size(); ++i)
      for (const auto& output : pictures[i].outputs)
        writeImage(reports[i].image, output, {pictures[i].scene.background, options.pngBits});
  } catch (const Error& error) {
    throw Error(ErrorKind::running, error.what());  // the places were checked by askedPictures()
  }
}

}  // namespace

void deliver(const PictureOptions& options, std::span<const AskedPicture> pictures,
             std::span<const RenderReport> reports, const MaxErrorReport* error) {
  writeFiles(options, pictures, reports);
  nlohmann::ordered_json views;
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    const auto& [scene, outputs] = pictures[i];
    if (options.json) {
      nlohmann::ordered_json& json = views.emplace_back(reportAsJson(scene, reports[i], outputs));
      if (error != nullptr) json["max_error"] = errorAsJson(*error);
    } else if (!options.quiet) {
      fmt::print("{}{}", reportAsText(scene, reports[i], outputs), error != nullptr ? errorAsText(*error) : "");
    }
  }
  if (options.json) printJson(views.size() == 1 ? views[0] : nlohmann::ordered_json{{kViewsKey, views}});
}

}  // namespace havs
