#pragma once
#include <filesystem>
#include <functional>
#include <span>
#include <string>

#include "core/error.h"

namespace havs {

/// A file that appears whole or not at all. Where the file system can (O_TMPFILE), it has no name until commit(), so
/// that a process killed while it writes leaves nothing. Elsewhere, and for the moment in which commit() takes the
/// place of an older file, it stands beside its place as .NAME.havs-PID, locked: the next OutputFile of that name
/// removes what a killed process left, as its lock is gone.
class OutputFile {
 public:
  /// Throws Error of that kind when `path` is a directory or no file (a device, a pipe), or its folder does not exist
  /// or cannot be written: of a place that was tried before the work began it is ErrorKind::running.
  explicit OutputFile(std::filesystem::path path, ErrorKind kind = ErrorKind::input);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  /// Where to write until commit(); child processes may, too. Its name says nothing of the target's.
  const std::filesystem::path& temporary() const { return temporary_; }
  /// Writes all bytes to temporary(). Throws Error{running} (disk full, ...).
  void write(std::span<const std::byte> bytes);
  void write(const std::string& text);
  /// Flushes to disk and puts the file in the target's place. Throws Error{running} (disk full, the folder has
  /// vanished, ...).
  void commit();
  /// For who writes to temporary() by other means: throws Error{running} with that error of the system.
  [[noreturn]] void failWriting(int error) const;

 private:
  /// make(name) gives 0 or the error, for free names beside the target until one is not taken; returns its error.
  int takeName(const std::function<int(const std::filesystem::path&)>& make);
  int linkTo(const std::filesystem::path& name) const;
  /// False where an older file is in the target's place.
  bool commitNameless();

  std::filesystem::path path_;
  std::filesystem::path temporary_;
  int descriptor_ = -1;   ///< the file
  bool isNamed_ = false;  ///< it has a name beside the target's
};

}  // namespace havs
