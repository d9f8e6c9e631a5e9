#pragma once
#include <filesystem>
#include <span>
#include <string>

namespace havs {

/// A file that appears whole or not at all: written beside its place under a name of its own, renamed by commit(),
/// removed when the object goes without commit().
class OutputFile {
 public:
  /// Throws Error{input} when `path` is a directory or its folder does not exist or cannot be written.
  explicit OutputFile(std::filesystem::path path);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  /// Where to write until commit(): same folder, same extension as the target.
  const std::filesystem::path& temporary() const { return temporary_; }
  /// Writes all bytes to temporary(). Throws Error{running} (disk full, ...).
  void write(std::span<const std::byte> bytes);
  void write(const std::string& text);
  /// Flushes to disk and renames over the target. Throws Error{running}.
  void commit();

 private:
  std::filesystem::path path_;
  std::filesystem::path temporary_;
  bool committed_ = false;
};

}  // namespace havs
