// havs render: draws a mesh and writes the picture.
#include <fmt/core.h>

#include <memory>

#include "app/commands.h"
#include "app/print_json.h"
#include "app/render_report.h"
#include "app/scene_options.h"
#include "core/error.h"
#include "core/progress.h"
#include "image/image.h"
#include "render/certificate_picture.h"
#include "render/render_scene.h"

namespace havs {
namespace {

struct RenderOptions {
  SceneOptions scene;
  std::vector<std::filesystem::path> outputs;
  int pngBits = 8;
  bool certificate = false;
  std::filesystem::path certificateMask;  ///< empty: none
  bool json = false;
  bool quiet = false;
};

void writeMask(const Scene& scene, const RenderReport& report, const std::filesystem::path& file) {
  if (!report.certificate)
    failInput("--visibility " + scene.visibility + " has no order certificate", "--certificate-mask");
  writeImage(certificatePicture(*report.certificate, report.image.width), file);
}

void render(const RenderOptions& options) {
  Scene scene = makeScene(options.scene);
  const bool wantsMask = !options.certificateMask.empty();
  if (options.certificate || wantsMask) scene.certificate = true;
  if (options.pngBits != 8 && options.pngBits != 16)
    failInput(fmt::format("must be 8 or 16, not {}", options.pngBits), "--png-bits");
  for (const auto& output : options.outputs) checkImagePath(output);
  if (wantsMask) checkImagePath(options.certificateMask);
  const RenderReport report = renderScene(scene, terminalProgress(options.quiet));
  for (const auto& output : options.outputs) writeImage(report.image, output, {scene.background, options.pngBits});
  if (wantsMask) writeMask(scene, report, options.certificateMask);
  if (options.json)
    printJson(reportAsJson(scene, report, options.outputs));
  else if (!options.quiet)
    fmt::print("{}", reportAsText(scene, report, options.outputs));
}

}  // namespace

void addRenderCommand(CLI::App& program) {
  CLI::App* command = program.add_subcommand("render", "Draw a mesh and write the picture");
  auto options = std::make_shared<RenderOptions>();
  addSceneOptions(*command, options->scene);
  const std::string group = "Output";
  command->add_option("-o,--output", options->outputs, "Picture: .png, .exr or .pfm; may be given several times")
      ->type_name("FILE")
      ->take_all()
      ->expected(1)
      ->group(group);
  command->add_option("--png-bits", options->pngBits, "Bits a channel: 8 (default) or 16")
      ->type_name("N")
      ->group(group);
  command->add_flag("--certificate", options->certificate, "Count the fragments that came too late to be ordered")
      ->group(group);
  command
      ->add_option("--certificate-mask", options->certificateMask,
                   "Picture of where they are, coloured by their number (implies --certificate)")
      ->type_name("FILE")
      ->group(group);
  command->add_flag("--json", options->json, "Report all that is known, as JSON")->group(group);
  command->add_flag("--quiet", options->quiet, "Print nothing but errors (and what --json asks for)")->group(group);
  command->callback([options] { render(*options); });
}

}  // namespace havs
