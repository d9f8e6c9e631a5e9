#include "app/command_line.h"

#include <fmt/core.h>

#include "app/commands.h"
#include "core/error.h"
#include "core/nearest_name.h"

namespace havs {
namespace {

std::vector<std::string> namesOfOptions(const CLI::App& command) {
  std::vector<std::string> names;
  for (const CLI::Option* option : command.get_options())
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  return names;
}

std::vector<std::string> namesOfCommands(const CLI::App& program) {
  std::vector<std::string> names;
  for (const CLI::App* command : program.get_subcommands([](const CLI::App*) { return true; }))
    names.push_back(command->get_name());
  return names;
}

/// The command that was named; the program itself when none was.
const CLI::App& chosenCommand(const CLI::App& program) {
  const auto chosen = program.get_subcommands();
  return chosen.empty() ? program : *chosen.front();
}

[[noreturn]] void failUnexpected(const CLI::App& program) {
  const CLI::App& command = chosenCommand(program);
  const std::string argument = program.remaining(true).front();
  const std::string option = argument.substr(0, argument.find('='));
  if (option.starts_with("-")) failInput("unknown option", option, didYouMean(option, namesOfOptions(command)));
  if (&command == &program) failInput("unknown command", argument, didYouMean(argument, namesOfCommands(program)));
  failInput("unexpected argument", argument, "see havs " + command.get_name() + " --help");
}

[[noreturn]] void failIncomplete(const CLI::App& program, const std::string& message) {
  const CLI::App& command = chosenCommand(program);
  const std::string name = &command == &program ? "havs" : "havs " + command.get_name();
  failInput(message, "", "see " + name + " --help");
}

}  // namespace

void runCommandLine(int argc, char** argv) {
  CLI::App program("Volume pictures of tetrahedral meshes with a known error", "havs");
  program.set_version_flag("--version", "havs " HAVS_VERSION);
  program.require_subcommand(1);
  addRenderCommand(program);
  addReferenceCommand(program);
  addPlanCommand(program);
  addCompareCommand(program);
  addStudyCommand(program);
  addInfoCommand(program);
  addMeshCommand(program);
  addSchemaCommand(program);
  try {
    program.parse(argc, argv);
  } catch (const CLI::ExtrasError&) {
    failUnexpected(program);
  } catch (const CLI::RequiredError& error) {
    if (!program.remaining(true).empty()) failUnexpected(program);
    failIncomplete(program, error.what());
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0)
      program.exit(error);  // --help and --version
    else
      failIncomplete(program, error.what());
  }
}

}  // namespace havs
