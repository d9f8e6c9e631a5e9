#pragma once
#include <cstddef>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>

namespace havs {

/// A file that several threads read pieces of at once. Not mapped into memory: a file that another program cuts short
/// meanwhile is an error then, not a crash.
class FileBlocks {
 public:
  /// Throws Error{input} when it cannot be opened.
  explicit FileBlocks(const std::filesystem::path& file);
  ~FileBlocks();
  FileBlocks(const FileBlocks&) = delete;
  FileBlocks& operator=(const FileBlocks&) = delete;

  const std::string& name() const { return name_; }
  /// Bytes, as it was opened.
  std::size_t size() const { return size_; }
  /// Fills `bytes` from the place `offset` on. False when the file does not reach so far or the disk refuses.
  bool read(std::size_t offset, std::span<char> bytes) const;

 private:
  std::string name_;
  int file_ = -1;
  std::size_t size_ = 0;
};

/// The whole text of a file, read by several threads.
class FileText {
 public:
  /// Throws Error{input} when the file cannot be opened or read to its end.
  explicit FileText(const std::filesystem::path& file);
  std::string_view view() const { return {text_.get(), size_}; }

 private:
  std::size_t size_ = 0;
  std::unique_ptr<char[]> text_;
};

}  // namespace havs
