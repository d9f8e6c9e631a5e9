// havs render: draws a mesh and writes the picture.
#include <memory>

#include "app/commands.h"
#include "app/max_error.h"
#include "app/picture_options.h"
#include "app/scene_views.h"
#include "core/error.h"
#include "core/progress.h"
#include "image/image.h"
#include "render/certificate_picture.h"
#include "render/render_scene.h"

namespace havs {
namespace {

struct RenderOptions {
  PictureOptions picture;
  bool certificate = false;
  std::filesystem::path certificateMask;  ///< empty: none
  MaxErrorOptions maxError;
};

void addCertificateOptions(CLI::App& command, RenderOptions& options) {
  const std::string group = "Output";
  command.add_flag("--certificate", options.certificate, "Count the fragments that came too late to be ordered")
      ->group(group);
  command
      .add_option("--certificate-mask", options.certificateMask,
                  "Picture of where they are, coloured by their number (implies --certificate)")
      ->type_name("FILE")
      ->group(group);
}

void writeCertificateMask(const Scene& scene, const RenderReport& report, const std::filesystem::path& file) {
  if (!report.certificate)
    failInput("--visibility " + scene.visibility + " has no order certificate", "--certificate-mask");
  writeImage(certificatePicture(*report.certificate, report.image.width), file);
}

/// Of what is for one picture.
void refuseSeveral(const RenderOptions& options) {
  if (!options.certificateMask.empty()) refuseViews(options.picture.scene, "--certificate-mask");
  if (goalOf(options.maxError)) refuseViews(options.picture.scene, "--max-error");
}

void render(const RenderOptions& options) {
  std::vector<AskedPicture> pictures = askedPictures(options.picture);
  refuseSeveral(options);
  const bool wantsMask = !options.certificateMask.empty();
  if (wantsMask) checkImagePath(options.certificateMask);
  if (options.certificate || wantsMask)
    for (AskedPicture& picture : pictures) picture.scene.certificate = true;
  const Progress progress = terminalProgress(options.picture.quiet);
  const std::optional<ErrorGoal> goal = goalOf(options.maxError);
  MaxErrorReport error;
  std::vector<RenderReport> reports;
  if (goal) {
    reports.push_back(renderWithin(*goal, options.maxError.verify, pictures.front().scene, error, progress));
  } else {
    reports = renderScenes(scenesOf(pictures), progress);
  }
  if (wantsMask) writeCertificateMask(pictures.front().scene, reports.front(), options.certificateMask);
  deliver(options.picture, pictures, reports, goal ? &error : nullptr);
}

}  // namespace

void addRenderCommand(CLI::App& program) {
  CLI::App* command = program.add_subcommand("render", "Draw a mesh and write the picture");
  auto options = std::make_shared<RenderOptions>();
  addPictureOptions(*command, options->picture);
  addCertificateOptions(*command, *options);
  addMaxErrorOptions(*command, options->maxError);
  command->callback([options] {
    readSceneFile(options->picture);
    render(*options);
  });
}

}  // namespace havs
