#include "app/picture_options.h"

#include <fmt/core.h>

#include "app/print_json.h"
#include "app/render_report.h"
#include "core/error.h"
#include "image/image.h"

namespace havs {

void addPictureOptions(CLI::App& command, PictureOptions& options) {
  addSceneOptions(command, options.scene);
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

Scene checkedScene(const PictureOptions& options) {
  const Scene scene = makeScene(options.scene);
  if (options.pngBits != 8 && options.pngBits != 16)
    failInput(fmt::format("must be 8 or 16, not {}", options.pngBits), "--png-bits");
  for (const auto& output : options.outputs) checkImagePath(output);
  return scene;
}

void deliver(const PictureOptions& options, const Scene& scene, const RenderReport& report,
             const MaxErrorReport* error) {
  for (const auto& output : options.outputs) writeImage(report.image, output, {scene.background, options.pngBits});
  if (options.json) {
    nlohmann::ordered_json json = reportAsJson(scene, report, options.outputs);
    if (error != nullptr) json["max_error"] = errorAsJson(*error);
    printJson(json);
  } else if (!options.quiet) {
    fmt::print("{}{}", reportAsText(scene, report, options.outputs), error != nullptr ? errorAsText(*error) : "");
  }
}

}  // namespace havs
