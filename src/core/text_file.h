#pragma once
#include <filesystem>
#include <string>

namespace havs {

/// The whole of a small file: a scene, a camera, a transfer function. Throws Error{input} when it cannot be read, is no
/// regular file, or is larger than 64 MiB.
std::string readTextFile(const std::filesystem::path& file);

}  // namespace havs
