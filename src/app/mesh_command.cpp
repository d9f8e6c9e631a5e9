// havs mesh: tetrahedralises a surface, or converts a mesh; adds fields from expressions.
#include <fmt/core.h>

#include <memory>

#include "app/commands.h"
#include "app/read_options.h"
#include "core/error.h"
#include "core/output_file.h"
#include "core/progress.h"
#include "mesh/read.h"
#include "mesh/scalar_field.h"

namespace havs {
namespace {

struct MeshOptions {
  std::filesystem::path input, output;
  ReadOptions read;
  std::vector<std::string> scalars;
  bool quiet = false;
};

struct ScalarExpression {
  std::string name, expression;
};

ScalarExpression parseScalar(const std::string& text) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos || equals == 0 || equals + 1 == text.size())
    failInput(fmt::format("'{}' is not a field", text), "--scalar", "write NAME=EXPRESSION, such as 'r=sqrt(x^2+y^2)'");
  return {text.substr(0, equals), text.substr(equals + 1)};
}

/// A field of that name gives way to the new one.
void addField(TetMesh& mesh, const ScalarExpression& scalar) {
  Field field = fieldFromExpression(mesh, scalar.name, scalar.expression);
  std::erase_if(mesh.pointFields, [&](const Field& f) { return f.name == scalar.name; });
  mesh.pointFields.push_back(std::move(field));
}

void checkMeshPath(const std::filesystem::path& file) {
  const std::string extension = file.extension().string();
  if (extension != ".vtu" && extension != ".node" && extension != ".ele")
    failInput(fmt::format("cannot write a mesh as '{}'", extension), file.string(), "use .vtu or .node");
  OutputFile probe(file);
}

void makeMesh(MeshOptions& options) {
  std::vector<ScalarExpression> scalars;
  for (const std::string& text : options.scalars) scalars.push_back(parseScalar(text));
  checkMeshPath(options.output);
  options.read.progress = terminalProgress(options.quiet);
  TetMesh mesh = readMesh(options.input, options.read);
  for (const ScalarExpression& scalar : scalars) addField(mesh, scalar);
  writeMesh(mesh, options.output);
  if (options.quiet) return;
  for (const std::string& note : mesh.notes) fmt::print("{:<9}{}\n", "note", note);
  fmt::print("{:<9}{}: {} points, {} tetrahedra\n", "mesh", options.output.string(), mesh.points.size(),
             mesh.tetrahedra.size());
}

}  // namespace

void addMeshCommand(CLI::App& program) {
  CLI::App* command = program.add_subcommand("mesh", "Fill a surface with tetrahedra, or convert a mesh; add fields");
  auto options = std::make_shared<MeshOptions>();
  addReadOptions(*command, options->input, options->read);
  command->add_option("-o,--output", options->output, "Mesh: .vtu or .node (with its .ele)")
      ->required()
      ->type_name("FILE");
  command
      ->add_option("--scalar", options->scalars,
                   "A field at the points, from an expression in x, y, z; may be given several times")
      ->type_name("NAME=EXPRESSION")
      ->take_all()
      ->expected(1);
  command->add_flag("--quiet", options->quiet, "Print nothing but errors");
  command->callback([options] { makeMesh(*options); });
}

}  // namespace havs
