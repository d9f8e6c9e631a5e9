// An array's data in the three ways of a .vtu file:
//   plain        [bytes] data                       in base64 one text, or the header a text of its own
//   compressed   [blocks, bytes of a block, bytes of the last one if it is shorter, compressed bytes of each] blocks
//   ascii        numbers between white space
// Blocks and stretches of text are independent of each other and done by several threads.
#include "mesh/vtu/vtu_data.h"

#include <libdeflate.h>
#include <lz4.h>

#include <algorithm>
#include <atomic>
#include <cstring>
#include <optional>
#include <vector>

#include "core/memory_budget.h"
#include "core/parallel.h"
#include "mesh/vtu/ascii_data.h"
#include "mesh/vtu/byte_stream.h"

namespace havs {
namespace {

/// Numbers of an array's header, 4 or 8 bytes each.
bool readHeader(const ByteStream& stream, std::size_t each, std::span<std::size_t> numbers) {
  std::vector<std::byte> bytes(each * numbers.size());
  if (!stream.read(0, bytes)) return false;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    numbers[i] = 0;
    std::memcpy(&numbers[i], bytes.data() + i * each, each);
  }
  return true;
}

class PlainData : public VtuData {
 public:
  PlainData(ByteStream stream, std::size_t skip, std::size_t count, std::size_t bytesEach)
      : stream_(stream), skip_(skip), count_(count), bytesEach_(bytesEach) {}

  bool visit(const Sink& sink) const override {
    constexpr std::size_t kNumbers = 12288;  // at a time: whole groups of base64, and the level 2 cache holds them
    std::atomic<bool> good = true;
    parallelFor(0, (count_ + kNumbers - 1) / kNumbers, 4, [&](std::size_t piece) {
      const std::size_t first = piece * kNumbers;
      thread_local std::vector<std::byte> bytes;
      bytes.resize(bytesEach_ * std::min(kNumbers, count_ - first));
      if (!stream_.read(skip_ + bytesEach_ * first, bytes) || !sink(first, bytes)) good = false;
    });
    return good;
  }

 private:
  ByteStream stream_;
  std::size_t skip_, count_, bytesEach_;
};

struct FreeDecompressor {
  void operator()(libdeflate_decompressor* d) const { libdeflate_free_decompressor(d); }
};

bool inflate(std::span<const std::byte> packed, std::span<std::byte> bytes) {
  thread_local const std::unique_ptr<libdeflate_decompressor, FreeDecompressor> decompressor(
      libdeflate_alloc_decompressor());
  return decompressor && libdeflate_zlib_decompress(decompressor.get(), packed.data(), packed.size(), bytes.data(),
                                                    bytes.size(), nullptr) == LIBDEFLATE_SUCCESS;
}

bool unpackLz4(std::span<const std::byte> packed, std::span<std::byte> bytes) {
  if (packed.size() > LZ4_MAX_INPUT_SIZE || bytes.size() > LZ4_MAX_INPUT_SIZE) return false;
  return LZ4_decompress_safe(reinterpret_cast<const char*>(packed.data()), reinterpret_cast<char*>(bytes.data()),
                             static_cast<int>(packed.size()),
                             static_cast<int>(bytes.size())) == static_cast<int>(bytes.size());
}

using Unpack = bool (*)(std::span<const std::byte> packed, std::span<std::byte> bytes);

class CompressedData : public VtuData {
 public:
  struct Blocks {
    std::vector<std::size_t> begin;  ///< of each block in the stream, and the end of the last
    std::size_t bytes = 0;           ///< of a block when it is inflated
    std::size_t lastBytes = 0;       ///< of the last one
  };
  CompressedData(ByteStream stream, Blocks blocks, std::size_t bytesEach, Unpack unpack)
      : stream_(stream), blocks_(std::move(blocks)), bytesEach_(bytesEach), unpack_(unpack) {}

  bool visit(const Sink& sink) const override {
    const std::size_t count = blocks_.begin.size() - 1;
    std::atomic<bool> good = true;
    parallelFor(0, count, 8, [&](std::size_t block) {
      thread_local std::vector<std::byte> packed, bytes;
      packed.resize(blocks_.begin[block + 1] - blocks_.begin[block]);
      bytes.resize(block + 1 == count ? blocks_.lastBytes : blocks_.bytes);
      if (!stream_.read(blocks_.begin[block], packed) || !unpack_(packed, bytes) ||
          !sink(block * (blocks_.bytes / bytesEach_), bytes))
        good = false;
    });
    return good;
  }

 private:
  ByteStream stream_;
  Blocks blocks_;
  std::size_t bytesEach_;
  Unpack unpack_;
};

std::unique_ptr<VtuData> openPlain(const ByteStream& stream, std::size_t headerBytes, std::size_t count,
                                   std::size_t bytesEach) {
  std::size_t bytes = 0;
  if (!readHeader(stream, headerBytes, {&bytes, 1}) || bytes != count * bytesEach) return {};
  if (stream.most() < headerBytes || bytes > stream.most() - headerBytes) return {};
  if (stream.padsAfter(headerBytes))
    return std::make_unique<PlainData>(stream.behind(headerBytes), 0, count, bytesEach);
  return std::make_unique<PlainData>(stream, headerBytes, count, bytesEach);
}

std::optional<CompressedData::Blocks> blocksOf(const ByteStream& stream, std::size_t headerBytes, std::size_t bytes,
                                               std::size_t bytesEach) {
  constexpr std::size_t kMostThatZipShrinks = 1100;  // deflate packs 1032 bytes into one at best, LZ4 255
  std::size_t head[3];
  if (!readHeader(stream, headerBytes, head)) return {};
  const auto [count, blockBytes, rest] = head;
  if (count == 0 || blockBytes == 0 || blockBytes % bytesEach != 0 || rest >= blockBytes) return {};
  if (bytes / kMostThatZipShrinks > stream.most() || count > stream.most() / headerBytes) return {};
  if (bytes / blockBytes + (rest > 0 ? 1 : 0) != count || bytes % blockBytes != rest) return {};
  needMemory(static_cast<double>(std::min(count, threadCount())) * static_cast<double>(std::min(blockBytes, bytes)),
             "unpacking the blocks of an array", stream.fileName());
  std::vector<std::size_t> numbers(3 + count);
  if (!readHeader(stream, headerBytes, numbers)) return {};
  CompressedData::Blocks blocks{{0}, blockBytes, rest == 0 ? blockBytes : rest};
  blocks.begin.reserve(count + 1);
  for (std::size_t i = 0; i < count; ++i) {
    if (numbers[3 + i] > stream.most() - blocks.begin.back()) return {};
    blocks.begin.push_back(blocks.begin.back() + numbers[3 + i]);
  }
  return blocks;
}

}  // namespace

std::unique_ptr<VtuData> openVtuData(const FileBlocks& file, const VtuLayout& layout, const VtuArray& array,
                                     std::size_t count) {
  if (array.coding == DataCoding::ascii) return openAsciiData(file, array, count);
  const std::size_t bytesEach = sizeOf(array.type);
  const ByteStream stream(file, array.begin, array.end, array.coding == DataCoding::base64);
  if (layout.compressor == Compressor::none) return openPlain(stream, layout.headerBytes, count, bytesEach);
  auto blocks = blocksOf(stream, layout.headerBytes, count * bytesEach, bytesEach);
  if (!blocks) return {};
  const std::size_t header = layout.headerBytes * (2 + blocks->begin.size());
  return std::make_unique<CompressedData>(stream.behind(header), std::move(*blocks), bytesEach,
                                          layout.compressor == Compressor::zlib ? inflate : unpackLz4);
}

}  // namespace havs
