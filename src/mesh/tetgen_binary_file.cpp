#include "mesh/tetgen_binary_file.h"

#include <algorithm>
#include <fstream>

#include "core/error.h"
#include "core/memory_budget.h"

namespace havs {

BinaryFile::BinaryFile(const std::filesystem::path& file) : file_(file.string()) {
  std::ifstream stream(file, std::ios::binary | std::ios::ate);
  const std::streamoff size = stream ? static_cast<std::streamoff>(stream.tellg()) : -1;
  if (size < 0) failInput("cannot be read", file_, "check that it exists and its permissions");
  needMemory(static_cast<double>(size), "the file", file_, "simplify the surface");
  bytes_.resize(static_cast<std::size_t>(size));
  stream.seekg(0);
  stream.read(reinterpret_cast<char*>(bytes_.data()), size);
  if (stream.gcount() != size) failInput("cannot be read to its end", file_, "check the disk and permissions");
}

std::string BinaryFile::line(const std::string& wanted) {
  const auto begin = bytes_.begin() + static_cast<std::ptrdiff_t>(position_);
  const auto end = std::find(begin, bytes_.end(), std::byte{'\n'});
  if (end == bytes_.end()) fail("the file ends, but " + wanted + " should follow", "is it cut short?");
  std::string text(static_cast<std::size_t>(end - begin), ' ');
  std::transform(begin, end, text.begin(), [](std::byte b) { return static_cast<char>(b); });
  if (!text.empty() && text.back() == '\r') text.pop_back();
  position_ = static_cast<std::size_t>(end - bytes_.begin()) + 1;
  return text;
}

void BinaryFile::skip(std::size_t bytes, const std::string& wanted) {
  if (bytes > left()) fail("the file ends, but " + wanted + " should follow", "is it cut short?");
  position_ += bytes;
}

void BinaryFile::take(std::span<std::byte> bytes, const std::string& wanted) {
  const std::size_t from = position_;
  skip(bytes.size(), wanted);
  std::copy_n(bytes_.begin() + static_cast<std::ptrdiff_t>(from), bytes.size(), bytes.begin());
}

void BinaryFile::reverse(std::span<std::byte> bytes) { std::ranges::reverse(bytes); }

void BinaryFile::fail(const std::string& what, const std::string& tryThis) const {
  failInput(what, file_ + ", byte " + std::to_string(position_), tryThis);
}

}  // namespace havs
