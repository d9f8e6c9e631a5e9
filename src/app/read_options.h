#pragma once
#include <CLI/CLI.hpp>
#include <filesystem>

#include "mesh/read.h"

namespace havs {

inline constexpr const char* kMaxMemoryOption = "--max-memory";
inline constexpr const char* kMaxMemoryHelp =
    "Most memory to take, as 500M or 8G: what needs more is refused before it is taken (default: what the machine has)";

/// Adds --max-memory, which holds from when it is read.
void addMaxMemoryOption(CLI::App& command);

/// Adds INPUT and what its reader may be told to a command.
void addReadOptions(CLI::App& command, std::filesystem::path& input, ReadOptions& options);

}  // namespace havs
