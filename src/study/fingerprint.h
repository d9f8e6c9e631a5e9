#pragma once
#include <filesystem>
#include <string>

#include "scene/prepared_scene.h"

namespace havs {

/// A number of 64 bits (FNV-1a), as hexadecimal digits, of all that a picture depends on beside camera and settings:
/// points, cells, scalars, transfer function.
std::string fingerprintOf(const PreparedScene& prepared);

/// The same of a file's bytes. Throws Error{input} when it cannot be read.
std::string fingerprintOf(const std::filesystem::path& file);

}  // namespace havs
