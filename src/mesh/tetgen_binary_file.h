#pragma once
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

namespace havs {

/// A file in memory, read number by number in a given byte order. Reading beyond its end throws Error{input}: "the file
/// ends", with what was `wanted` and the byte.
class BinaryFile {
 public:
  /// Throws Error{input} when it cannot be read.
  explicit BinaryFile(const std::filesystem::path& file);

  void setBigEndian(bool big) { swap_ = big != (std::endian::native == std::endian::big); }
  template <class T>
  T get(const std::string& wanted) {
    static_assert(std::is_arithmetic_v<T>);
    std::byte bytes[sizeof(T)];
    take(bytes, wanted);
    if (swap_) reverse(bytes);
    T value;
    std::memcpy(&value, bytes, sizeof(T));
    return value;
  }
  /// The next line without its end.
  std::string line(const std::string& wanted);
  void skip(std::size_t bytes, const std::string& wanted);
  std::size_t position() const { return position_; }
  std::size_t left() const { return bytes_.size() - position_; }
  /// Throws Error{input} with this file and byte.
  [[noreturn]] void fail(const std::string& what, const std::string& tryThis = "") const;

 private:
  void take(std::span<std::byte> bytes, const std::string& wanted);
  static void reverse(std::span<std::byte> bytes);

  std::string file_;
  std::vector<std::byte> bytes_;
  std::size_t position_ = 0;
  bool swap_ = false;
};

}  // namespace havs
