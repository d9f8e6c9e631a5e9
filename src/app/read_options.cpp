#include "app/read_options.h"

#include "app/table_names.h"
#include "core/memory_budget.h"

namespace havs {

void addMaxMemoryOption(CLI::App& command) {
  const auto set = [](const std::string& text) { limitMemory(parseMemorySize(text, kMaxMemoryOption)); };
  command.add_option_function<std::string>(kMaxMemoryOption, set, kMaxMemoryHelp)->type_name("SIZE");
}

void addReadOptions(CLI::App& command, std::filesystem::path& input, ReadOptions& options) {
  command.add_option("INPUT", input, "Mesh: " + meshExtensions())->required()->type_name("");
  command.add_option("--q", options.plot3dSolution, "PLOT3D's solution (default: found beside the grid)")
      ->type_name("FILE");
  command
      .add_option("--tetgen", options.tetgenSwitches,
                  "TetGen's switches for a surface (default " + options.tetgenSwitches + ")")
      ->type_name("SWITCHES");
  addMaxMemoryOption(command);
}

}  // namespace havs
