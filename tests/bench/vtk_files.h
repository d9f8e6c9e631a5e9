#pragma once
#include <filesystem>

namespace havs::bench {

/// Reads a .vtu by VTK's reader, in this process.
void readByVtk(const std::filesystem::path& file);

/// Writes the .vtu again, in every encoding that writers use, each under its name: raw.vtu, base64.vtu, zlib.vtu (VTK's
/// default but for the encoding), base64_zlib.vtu (VTK's default), inline.vtu, inline_zlib.vtu, ascii.vtu, lz4.vtu.
void writeEncodings(const std::filesystem::path& file, const std::filesystem::path& folder);

}  // namespace havs::bench
