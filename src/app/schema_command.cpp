// havs schema: the JSON schema of scene files.
#include <fmt/core.h>

#include "app/commands.h"
#include "app/scene_file.h"

namespace havs {

void addSchemaCommand(CLI::App& program) {
  CLI::App* command = program.add_subcommand("schema", "Print the JSON schema of scene files");
  command->callback([] { fmt::print("{}", sceneFileSchema()); });
}

}  // namespace havs
