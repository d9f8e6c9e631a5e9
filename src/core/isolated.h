#pragma once
// Work of libraries that may exit, abort, print, leak or crash on bad input, done in a child process: whatever happens
// there stays there, and its memory goes with it. The child hands back bytes through an anonymous file in memory.
#include <cstddef>
#include <cstring>
#include <functional>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

namespace havs {

/// Writes values one after another to a file in memory.
class ByteWriter {
 public:
  explicit ByteWriter(int file) : file_(file) { buffer_.reserve(kBufferBytes); }
  template <class T>
  void put(const T& value) {
    static_assert(std::is_trivially_copyable_v<T>);
    write(std::as_bytes(std::span(&value, 1)));
  }
  template <class T>
  void put(const std::vector<T>& values) {
    static_assert(std::is_trivially_copyable_v<T>);
    put(values.size());
    write(std::as_bytes(std::span(values)));
  }
  void put(const std::string& text);
  /// Throws Error{running} when the machine has no memory left for the bytes.
  void flush();

 private:
  static constexpr std::size_t kBufferBytes = 1 << 16;
  void write(std::span<const std::byte> bytes);
  void writeThrough(std::span<const std::byte> bytes) const;

  int file_;
  std::vector<std::byte> buffer_;
};

/// Reads what a ByteWriter wrote, in the same order. Owns the file.
class ByteReader {
 public:
  explicit ByteReader(int file);
  ~ByteReader();
  ByteReader(ByteReader&& other) noexcept;
  ByteReader& operator=(ByteReader&&) = delete;
  int file() const { return file_; }
  /// Back to the first byte of what the file holds now.
  void rewind();

  template <class T>
  T get() {
    T value;
    read(std::as_writable_bytes(std::span(&value, 1)));
    return value;
  }
  template <class T>
  std::vector<T> getVector() {
    std::vector<T> values(checkedCount(get<std::size_t>(), sizeof(T)));
    read(std::as_writable_bytes(std::span(values)));
    return values;
  }
  std::string getString();

 private:
  void read(std::span<std::byte> bytes);
  std::size_t checkedCount(std::size_t count, std::size_t bytesEach) const;

  int file_;
  std::size_t position_ = 0;
  std::size_t size_ = 0;
};

/// What came of work in a child process.
struct IsolatedRun {
  ByteReader reply;   ///< what the work wrote
  std::string death;  ///< empty when the work came to its end, else how it died: "Segmentation fault", "exit status 3"
  std::string printed;  ///< the first 64 KiB that it printed on standard output and error
};

/// Runs `work` in a child process (of one thread: it must not use core/parallel.h) and waits for its end. The child may
/// take as much memory as memoryLimit() (core/memory_budget.h), so that a header's lie about counts ends in
/// std::bad_alloc. An Error that `work` throws is thrown here; std::bad_alloc and other exceptions as Error{running}.
IsolatedRun runIsolated(const std::function<void(ByteWriter&)>& work);

}  // namespace havs
