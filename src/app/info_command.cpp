// havs info: what a mesh holds, how good it is, and what is wrong with it.
#include <fmt/core.h>

#include <memory>

#include "app/commands.h"
#include "app/mesh_report.h"
#include "app/print_json.h"
#include "app/read_options.h"
#include "core/progress.h"
#include "mesh/read.h"

namespace havs {
namespace {

struct InfoOptions {
  std::filesystem::path mesh;
  ReadOptions read;
  std::string field;
  bool json = false;
  bool quiet = false;
};

void info(InfoOptions& options) {
  options.read.progress = terminalProgress(options.quiet);
  const MeshReport report = reportMesh(readMesh(options.mesh, options.read), options.mesh, options.field);
  if (options.json)
    printJson(reportAsJson(report));
  else if (!options.quiet)
    fmt::print("{}", reportAsText(report));
}

}  // namespace

void addInfoCommand(CLI::App& program) {
  CLI::App* command = program.add_subcommand("info", "Counts, fields, ranges, quality and defects of a mesh");
  auto options = std::make_shared<InfoOptions>();
  addReadOptions(*command, options->mesh, options->read);
  command
      ->add_option("--field", options->field,
                   "The field to look at: NAME, NAME:x, point:NAME, ... (default: the one drawn)")
      ->type_name("NAME");
  command->add_flag("--json", options->json, "Report as JSON");
  command->add_flag("--quiet", options->quiet, "Print nothing but errors (and what --json asks for)");
  command->callback([options] { info(*options); });
}

}  // namespace havs
