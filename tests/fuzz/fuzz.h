#pragma once
// What the fuzz targets share. Each target is a file with one LLVMFuzzerTestOneInput: run by libFuzzer (preset `fuzz`),
// and over its corpus by replay_test.cpp. What a target must not see leaves it as an exception that is no havs::Error.
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string_view>

#include "core/error.h"
#include "image/image.h"
#include "mesh/tet_mesh.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace havs::fuzz {

inline std::string_view textOf(const std::uint8_t* data, std::size_t size) {
  return {reinterpret_cast<const char*>(data), size};
}

/// What a target's process may have in memory (core/memory_budget.h).
inline constexpr std::size_t kMemoryLimit = std::size_t{256} << 20;

/// Writes the bytes to a file called `name` in a folder of this process.
std::filesystem::path asFile(const std::string& name, std::string_view bytes);

/// Calls read(); a refusal (havs::Error) is as good as a result, any other exception is not caught.
template <class Read>
void readOrRefuse(const Read& read) {
  try {
    read();
  } catch (const Error&) {
  }
}

/// Throws std::logic_error, which no target catches.
void require(bool holds, const char* what);
/// As many values as the header of each promises, and point numbers within the points.
void requireSound(const TetMesh& mesh);
void requireSound(const Image& image);

}  // namespace havs::fuzz
