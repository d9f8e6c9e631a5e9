#include "mesh/vtu/byte_stream.h"

#include <algorithm>
#include <cstring>
#include <vector>

#include "mesh/vtu/base64.h"

namespace havs {
namespace {

/// The last group of a text, which may be padded: its 1, 2 or 3 bytes; 0 when it is broken.
std::size_t decodeLastGroup(std::span<const char> group, std::span<std::byte, 3> bytes) {
  char text[4];
  std::copy_n(group.begin(), 4, text);
  const std::size_t padding = text[3] != '=' ? 0 : text[2] != '=' ? 1 : 2;
  std::fill_n(text + 4 - padding, padding, 'A');
  return decodeBase64(text, bytes) ? 3 - padding : 0;
}

}  // namespace

bool ByteStream::read(std::size_t offset, std::span<std::byte> bytes) const {
  if (bytes.empty()) return true;
  if (!base64_) {
    if (offset > end_ - begin_ || bytes.size() > end_ - begin_ - offset) return false;
    return file_->read(begin_ + offset, {reinterpret_cast<char*>(bytes.data()), bytes.size()});
  }
  const std::size_t firstGroup = offset / 3, groups = (offset + bytes.size() + 2) / 3 - firstGroup;
  if (groups > (end_ - begin_) / 4 || firstGroup > (end_ - begin_) / 4 - groups) return false;
  thread_local std::vector<char> text;
  thread_local std::vector<std::byte> decoded;
  text.resize(4 * groups);
  decoded.resize(3 * groups);
  if (!file_->read(begin_ + 4 * firstGroup, text)) return false;
  const std::span all(decoded);
  if (!decodeBase64(std::span(text).first(4 * (groups - 1)), all)) return false;
  const std::size_t last = decodeLastGroup(std::span(text).last(4), all.last<3>());
  const std::size_t skipped = offset - 3 * firstGroup;
  if (last == 0 || 3 * (groups - 1) + last < skipped + bytes.size()) return false;
  std::memcpy(bytes.data(), decoded.data() + skipped, bytes.size());
  return true;
}

ByteStream ByteStream::behind(std::size_t bytes) const {
  const std::size_t length = base64_ ? (bytes + 2) / 3 * 4 : bytes;
  return {*file_, std::min(begin_ + length, end_), end_, base64_};
}

bool ByteStream::padsAfter(std::size_t bytes) const {
  const std::size_t length = (bytes + 2) / 3 * 4;
  char last = '\0';
  return base64_ && bytes % 3 != 0 && length <= end_ - begin_ && file_->read(begin_ + length - 1, {&last, 1}) &&
         last == '=';
}

}  // namespace havs
