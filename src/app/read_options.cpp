#include "app/read_options.h"

#include "app/table_names.h"

namespace havs {

void addReadOptions(CLI::App& command, std::filesystem::path& input, ReadOptions& options) {
  command.add_option("INPUT", input, "Mesh: " + meshExtensions())->required()->type_name("");
  command.add_option("--q", options.plot3dSolution, "PLOT3D's solution (default: found beside the grid)")
      ->type_name("FILE");
  command
      .add_option("--tetgen", options.tetgenSwitches,
                  "TetGen's switches for a surface (default " + options.tetgenSwitches + ")")
      ->type_name("SWITCHES");
}

}  // namespace havs
