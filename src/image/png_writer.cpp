// Writing PNG: 8 or 16 bits a channel; RGB over a background, straight RGBA without one. Rows are made and filtered by
// all threads, then deflated at once by libdeflate, which needs the whole picture (libpng's rows go through zlib: six
// times the time for files 3 to 12 % smaller, docs/07-performance.md). One filter serves, the difference to the row
// above: volume pictures are smooth. Source: PNG specification, W3C, 2nd edition, sections 5, 9, 10.
#include <libdeflate.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <new>
#include <span>
#include <string_view>
#include <vector>

#include "core/parallel.h"
#include "image/background.h"
#include "image/file_pointer.h"
#include "image/formats.h"

namespace havs {
namespace {

constexpr int kLevel = 4;  // of libdeflate
constexpr std::uint8_t kUp = 2;

/// round(most * value), value clamped to [0, 1]; 0 for a value that is not a number. The product is exact in double.
std::uint32_t quantised(float value, double most) {
  if (!(value > 0)) return 0;
  return static_cast<std::uint32_t>(most * std::min(1.0, static_cast<double>(value)) + 0.5);
}

class Rows {
 public:
  Rows(const Image& image, const ImageFileOptions& options)
      : image_(image),
        options_(options),
        channels_(options.background ? 3 : 4),
        bytes_(static_cast<std::size_t>(image.width) * channels_ * (options.pngBits == 16 ? 2 : 1)) {}

  /// All rows, each behind the number of its filter.
  std::vector<std::uint8_t> filtered() const {
    const auto height = static_cast<std::size_t>(image_.height);
    std::vector<std::uint8_t> result(height * (1 + bytes_));
    constexpr std::size_t kRows = 16;  // each block makes the row above its first one again
    parallelBlocks(0, height, kRows, [&](std::size_t first, std::size_t last) {
      std::vector<std::uint8_t> above(bytes_, 0), row(bytes_);
      if (first > 0) pack(first - 1, above);
      for (std::size_t y = first; y < last; ++y) {
        pack(y, row);
        std::uint8_t* const to = &result[y * (1 + bytes_)];
        to[0] = kUp;
        for (std::size_t i = 0; i < bytes_; ++i) to[1 + i] = static_cast<std::uint8_t>(row[i] - above[i]);
        row.swap(above);
      }
    });
    return result;
  }

 private:
  /// One row as PNG holds it (16 bits: most significant byte first).
  void pack(std::size_t y, std::span<std::uint8_t> row) const {
    const float* pixel = image_.pixel(0, static_cast<int>(y));
    const Color behind = options_.background ? options_.background->at(static_cast<int>(y), image_.height) : Color{};
    for (std::size_t at = 0; at < row.size(); pixel += 4) {
      if (options_.background)
        at = put(over(pixel, behind), at, row);
      else
        at = put(straight(pixel), at, row);
    }
  }

  template <std::size_t N>
  std::size_t put(const std::array<float, N>& values, std::size_t at, std::span<std::uint8_t> row) const {
    if (options_.pngBits == 16) {
      for (const float value : values) {
        const std::uint32_t number = quantised(value, 65535);
        row[at++] = static_cast<std::uint8_t>(number >> 8);
        row[at++] = static_cast<std::uint8_t>(number & 0xff);
      }
    } else {
      for (const float value : values) row[at++] = static_cast<std::uint8_t>(quantised(value, 255));
    }
    return at;
  }

  const Image& image_;
  const ImageFileOptions& options_;
  std::size_t channels_;
  std::size_t bytes_;  // of a row
};

struct FreeCompressor {
  void operator()(libdeflate_compressor* compressor) const { libdeflate_free_compressor(compressor); }
};

std::vector<std::uint8_t> deflated(const std::vector<std::uint8_t>& bytes) {
  const std::unique_ptr<libdeflate_compressor, FreeCompressor> compressor(libdeflate_alloc_compressor(kLevel));
  if (!compressor) throw std::bad_alloc();
  std::vector<std::uint8_t> result(libdeflate_zlib_compress_bound(compressor.get(), bytes.size()));
  result.resize(libdeflate_zlib_compress(compressor.get(), bytes.data(), bytes.size(), result.data(), result.size()));
  return result;
}

std::array<std::uint8_t, 4> bigEndian(std::uint32_t value) {
  return {static_cast<std::uint8_t>(value >> 24), static_cast<std::uint8_t>(value >> 16),
          static_cast<std::uint8_t>(value >> 8), static_cast<std::uint8_t>(value)};
}

bool write(std::FILE* file, std::span<const std::uint8_t> bytes) {
  return bytes.empty() || std::fwrite(bytes.data(), 1, bytes.size(), file) == bytes.size();
}

bool writeChunk(std::FILE* file, std::string_view type, std::span<const std::uint8_t> data) {
  const std::uint32_t crcOfType = libdeflate_crc32(0, type.data(), type.size());
  const std::uint32_t crc = data.empty() ? crcOfType : libdeflate_crc32(crcOfType, data.data(), data.size());
  return write(file, bigEndian(static_cast<std::uint32_t>(data.size()))) &&
         std::fwrite(type.data(), 1, type.size(), file) == type.size() && write(file, data) &&
         write(file, bigEndian(crc));
}

bool writeHeader(std::FILE* file, const Image& image, const ImageFileOptions& options) {
  constexpr std::uint8_t kSignature[] = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
  constexpr std::uint8_t kRgb = 2, kRgba = 6;
  const auto width = bigEndian(static_cast<std::uint32_t>(image.width));
  const auto height = bigEndian(static_cast<std::uint32_t>(image.height));
  std::array<std::uint8_t, 13> header{};  // its last three: deflate, the five filters, no interlacing
  std::copy(width.begin(), width.end(), header.begin());
  std::copy(height.begin(), height.end(), header.begin() + 4);
  header[8] = static_cast<std::uint8_t>(options.pngBits);
  header[9] = options.background ? kRgb : kRgba;
  return write(file, kSignature) && writeChunk(file, "IHDR", header);
}

bool writeData(std::FILE* file, std::span<const std::uint8_t> data) {
  constexpr std::size_t kLongestChunk = 1 << 30;  // 2^31 - 1 is allowed
  for (; !data.empty(); data = data.subspan(std::min(kLongestChunk, data.size())))
    if (!writeChunk(file, "IDAT", data.first(std::min(kLongestChunk, data.size())))) return false;
  return true;
}

}  // namespace

bool writePng(const Image& image, const std::filesystem::path& file, const ImageFileOptions& options) {
  const FilePointer opened(std::fopen(file.c_str(), "wb"));
  if (!opened) return false;
  const std::vector<std::uint8_t> data = deflated(Rows(image, options).filtered());
  std::FILE* const stream = opened.get();
  return writeHeader(stream, image, options) && writeData(stream, data) && writeChunk(stream, "IEND", {}) &&
         std::fflush(stream) == 0;
}

}  // namespace havs
