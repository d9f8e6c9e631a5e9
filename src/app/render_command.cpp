// havs render: draws a mesh and writes the picture.
#include <memory>

#include "app/commands.h"
#include "app/picture_options.h"
#include "core/progress.h"

namespace havs {

void addRenderCommand(CLI::App& program) {
  CLI::App* command = program.add_subcommand("render", "Draw a mesh and write the picture");
  auto options = std::make_shared<PictureOptions>();
  addPictureOptions(*command, *options);
  command->callback([options] {
    const Scene scene = checkedScene(*options);
    deliver(*options, scene, renderScene(scene, terminalProgress(options->quiet)));
  });
}

}  // namespace havs
