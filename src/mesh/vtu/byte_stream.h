#pragma once
#include <cstddef>
#include <span>
#include <string>

#include "mesh/file_blocks.h"

namespace havs {

/// Bytes that a file holds raw or in base64, from one place on. Several threads may read.
class ByteStream {
 public:
  /// `begin` and `end` are places in the file.
  ByteStream(const FileBlocks& file, std::size_t begin, std::size_t end, bool base64)
      : file_(&file), begin_(begin), end_(end), base64_(base64) {}
  /// Decodes bytes offset, offset + 1, ... of the stream. False when there are fewer, or it is no base64.
  bool read(std::size_t offset, std::span<std::byte> bytes) const;
  /// The stream that begins behind the first `bytes` of this one; in base64 those are a text of their own, padded.
  ByteStream behind(std::size_t bytes) const;
  /// Whether a text of just `bytes` begins the stream: in base64 it ends in padding, unless bytes is divisible by 3.
  bool padsAfter(std::size_t bytes) const;
  const std::string& fileName() const { return file_->name(); }
  /// How many bytes there can be at most.
  std::size_t most() const { return base64_ ? (end_ - begin_) / 4 * 3 : end_ - begin_; }

 private:
  const FileBlocks* file_;
  std::size_t begin_;
  std::size_t end_;
  bool base64_;
};

}  // namespace havs
