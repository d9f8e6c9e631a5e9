#pragma once
#include <CLI/CLI.hpp>
#include <filesystem>

#include "mesh/read.h"

namespace havs {

/// Adds INPUT and what its reader may be told to a command.
void addReadOptions(CLI::App& command, std::filesystem::path& input, ReadOptions& options);

}  // namespace havs
