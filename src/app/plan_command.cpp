// havs plan: what would run to draw a scene, and why.
#include <fmt/core.h>

#include <memory>

#include "app/commands.h"
#include "app/picture_options.h"
#include "app/plan_report.h"
#include "app/print_json.h"
#include "core/progress.h"
#include "render/render_scene.h"

namespace havs {

void addPlanCommand(CLI::App& program) {
  CLI::App* command = program.add_subcommand(
      "plan",
      "Print what would run to draw a mesh or a scene, and why: vertex data, tables, programs, targets, passes. Takes "
      "the options of havs render; nothing is drawn, and no picture written.");
  auto options = std::make_shared<PictureOptions>();
  addPictureOptions(*command, *options);
  command->callback([options] {
    readSceneFile(*options);
    const RenderPlan plan = planScene(askedPictures(*options).front().scene, terminalProgress(options->quiet));
    if (options->json) {
      printJson({{"plan", planAsJson(plan.items)}});
    } else {
      fmt::print("{}", planAsText(plan.items));
    }
  });
}

}  // namespace havs
