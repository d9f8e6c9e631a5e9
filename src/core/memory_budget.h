#pragma once
#include <cstddef>
#include <string>

namespace havs {

/// Bytes of "500M", "8G", "1.5T", "4096": K, M, G and T are powers of 1024, with or without B or iB behind. Throws
/// Error{input} for what is none, 0 included; `option` names it.
std::size_t parseMemorySize(const std::string& text, const std::string& option);

/// The most that this process may have in memory at once, in bytes: all that the machine has, unless limitMemory said
/// less. A child process (core/isolated.h) may have as much of its own.
std::size_t memoryLimit();
/// From now on, for the whole process; 0: what the machine has.
void limitMemory(std::size_t bytes);

/// To be called before memory is taken by a number that comes from outside: a file's header, an option. Throws
/// Error{input} when `bytes` more than the process has now are beyond the limit: "WHERE: WHAT needs 24.0 GB, ...; TRY".
/// A double, so that no product of sizes overflows.
void needMemory(double bytes, const std::string& what, const std::string& where = "", const std::string& tryThis = "");

}  // namespace havs
