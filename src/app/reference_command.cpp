// havs reference: draws a mesh by the ground truth.
#include <fmt/core.h>

#include <memory>

#include "app/commands.h"
#include "app/picture_options.h"
#include "app/scene_views.h"
#include "core/error.h"
#include "core/progress.h"
#include "image/mask.h"

namespace havs {
namespace {

struct ReferenceOptions {
  PictureOptions picture;
  std::filesystem::path edgeMask;
};

void draw(const ReferenceOptions& options) {
  const std::vector<AskedPicture> pictures = askedPictures(options.picture);
  const bool edgeMask = !options.edgeMask.empty();
  if (edgeMask) {
    refuseViews(options.picture.scene, "--edge-mask");
    checkMaskPath(options.edgeMask);
  }
  const std::vector<RenderReport> reports =
      drawReferences(scenesOf(pictures), edgeMask, terminalProgress(options.picture.quiet));
  const Scene& scene = pictures.front().scene;
  if (edgeMask) writeMask(reports.front().edgeMask, scene.width, scene.height, options.edgeMask);
  deliver(options.picture, pictures, reports);
}

}  // namespace

void addReferenceCommand(CLI::App& program) {
  CLI::App* command = program.add_subcommand(
      "reference",
      "Draw a mesh by the ground truth: every cell of every ray, integrated exactly in double precision. "
      "Takes all options of havs render; those of the method, but for --threads and --repeat, are checked and have no "
      "effect.");
  auto options = std::make_shared<ReferenceOptions>();
  addPictureOptions(*command, options->picture);
  command
      ->add_option("--edge-mask", options->edgeMask,
                   "PNG, white where a rasteriser's grid may put a pixel on either side of a boundary edge, for "
                   "havs compare --mask")
      ->type_name("FILE")
      ->group(kOutputGroup);
  command->callback([options] {
    readSceneFile(options->picture);
    draw(*options);
  });
}

}  // namespace havs
