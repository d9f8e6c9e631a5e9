#pragma once
#include <CLI/CLI.hpp>

namespace havs {

/// Each adds one command to the program: its options, and what runs when it is named. Adding a command is adding a file
/// with such a function and its line in command_line.cpp.
void addRenderCommand(CLI::App& program);
void addPlanCommand(CLI::App& program);
void addReferenceCommand(CLI::App& program);
void addStudyCommand(CLI::App& program);
void addInfoCommand(CLI::App& program);
void addMeshCommand(CLI::App& program);
void addCompareCommand(CLI::App& program);
void addSchemaCommand(CLI::App& program);

}  // namespace havs
