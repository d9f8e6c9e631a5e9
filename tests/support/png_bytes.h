#pragma once
#include <libdeflate.h>

#include <cstdint>
#include <string>

namespace havs::test {

/// The number's four bytes, the highest first.
inline std::string bigEndian(std::uint32_t n) {
  return {static_cast<char>(n >> 24), static_cast<char>(n >> 16), static_cast<char>(n >> 8), static_cast<char>(n)};
}

/// Packed as zlib does, at its best.
inline std::string zlibBytes(const std::string& bytes, int level = 9) {
  libdeflate_compressor* const compressor = libdeflate_alloc_compressor(level);
  std::string packed(libdeflate_zlib_compress_bound(compressor, bytes.size()), '\0');
  packed.resize(libdeflate_zlib_compress(compressor, bytes.data(), bytes.size(), packed.data(), packed.size()));
  libdeflate_free_compressor(compressor);
  return packed;
}

/// A PNG file, 8 bits RGBA, that says it has this size and holds these rows.
inline std::string pngBytes(std::uint32_t width, std::uint32_t height, const std::string& rows) {
  const auto chunk = [](const std::string& kind, const std::string& data) {
    const std::string checked = kind + data;
    return bigEndian(static_cast<std::uint32_t>(data.size())) + checked +
           bigEndian(libdeflate_crc32(0, checked.data(), checked.size()));
  };
  const std::string kind("\x08\x06\0\0\0", 5);
  return "\x89PNG\r\n\x1a\n" + chunk("IHDR", bigEndian(width) + bigEndian(height) + kind) +
         chunk("IDAT", zlibBytes(rows)) + chunk("IEND", "");
}

}  // namespace havs::test
