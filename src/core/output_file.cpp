#include "core/output_file.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <utility>

#include "core/error.h"
#include "core/stopping.h"

namespace havs {
namespace fs = std::filesystem;
namespace {

constexpr mode_t kMode = 0666;  // less the umask

fs::path folderOf(const fs::path& file) { return file.has_parent_path() ? file.parent_path() : fs::path("."); }

/// Of all names beside `file` that are ours.
std::string prefixOf(const fs::path& file) {
  constexpr std::size_t kMost = 200;  // a name has at most 255 bytes
  return "." + file.filename().string().substr(0, kMost) + ".havs-";
}

fs::path freeName(const fs::path& file, int attempt) {
  return folderOf(file) / (prefixOf(file) + std::to_string(getpid()) + "-" + std::to_string(attempt));
}

[[noreturn]] void failOpening(ErrorKind kind, const fs::path& file, int error) {
  throw Error(kind, std::string("cannot write there: ") + std::strerror(error), file.string(), "choose another place");
}

void checkPath(const fs::path& file, ErrorKind kind) {
  std::error_code error;
  const fs::file_type type = fs::status(file, error).type();
  if (file.filename().empty() || type == fs::file_type::directory)
    throw Error(kind, "the output is a directory", file.string(), "name a file in it");
  const fs::path folder = folderOf(file);
  std::error_code ignored;
  if (!fs::is_directory(folder, ignored))
    throw Error(kind, "the output's folder does not exist", folder.string(), "create it first");
  if (type == fs::file_type::none) failOpening(kind, file, error.value());
  if (type != fs::file_type::regular && type != fs::file_type::not_found)
    throw Error(kind, "something is there that is no file", file.string(), "choose another place");
}

/// Removes what killed processes left beside `file`.
void removeLeftovers(const fs::path& file) {
  std::error_code error;
  const std::string prefix = prefixOf(file);
  for (fs::directory_iterator entry(folderOf(file), error), end; !error && entry != end; entry.increment(error)) {
    if (!entry->path().filename().string().starts_with(prefix)) continue;
    const int found = open(entry->path().c_str(), O_RDWR | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK);
    if (found < 0) continue;
    if (flock(found, LOCK_EX | LOCK_NB) == 0) unlink(entry->path().c_str());
    close(found);
  }
}

std::string nameOf(int descriptor) { return "/proc/self/fd/" + std::to_string(descriptor); }

/// A file without a name in that folder; -1: the file system has none.
int openNameless(const fs::path& folder) {
  const int file = open(folder.c_str(), O_TMPFILE | O_RDWR | O_CLOEXEC, kMode);
  if (file < 0 || access(nameOf(file).c_str(), W_OK) == 0) return file;
  close(file);  // without /proc it could not be named later
  return -1;
}

/// Locks a file just made. EEXIST (and it is closed) where another process took it for a dead one's before: then it has
/// no name any more, or soon. Where there are no locks, nobody takes it.
int keepFromOthers(int& file) {
  struct stat status {};
  const bool taken = (flock(file, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) ||
                     (fstat(file, &status) == 0 && status.st_nlink == 0);
  if (!taken) return 0;
  close(std::exchange(file, -1));
  return EEXIST;
}

/// What most often is behind an error of writing.
const char* adviceOn(int error) {
  switch (error) {
    case ENOENT:
    case ENOTDIR:
      return "was its folder removed meanwhile?";
    case EISDIR:
    case EXDEV:
      return "was something else put in its place meanwhile?";
    case EACCES:
    case EPERM:
    case EROFS:
      return "were its folder's rights changed meanwhile?";
    case EFBIG:
      return "is the size of files limited (ulimit -f)?";
    default:
      return "is the disk full?";
  }
}

}  // namespace

OutputFile::OutputFile(fs::path path, ErrorKind kind) : path_(std::move(path)) {
  checkPath(path_, kind);
  removeLeftovers(path_);
  descriptor_ = openNameless(folderOf(path_));
  temporary_ = nameOf(descriptor_);
  if (descriptor_ < 0) {
    const int error = takeName([this](const fs::path& name) {
      descriptor_ = open(name.c_str(), O_CREAT | O_EXCL | O_RDWR | O_CLOEXEC, kMode);
      return descriptor_ >= 0 ? keepFromOthers(descriptor_) : errno;
    });
    if (error != 0) failOpening(kind, path_, error);
  } else {
    flock(descriptor_, LOCK_EX | LOCK_NB);
  }
}

int OutputFile::takeName(const std::function<int(const fs::path&)>& make) {
  const StopDelay delay;
  for (int attempt = 0;; ++attempt) {
    const fs::path name = freeName(path_, attempt);
    const int error = make(name);
    if (error == EEXIST) continue;
    if (error != 0) return error;
    noteTemporary(delay, name);
    temporary_ = name;
    isNamed_ = true;
    return 0;
  }
}

OutputFile::~OutputFile() {
  if (isNamed_) {
    const StopDelay delay;
    unlink(temporary_.c_str());
    noteTemporaryGone(delay, temporary_);
  }
  close(descriptor_);
}

void OutputFile::write(std::span<const std::byte> bytes) {
  std::ofstream stream(temporary_, std::ios::binary | std::ios::trunc);
  stream.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  stream.close();
  if (!stream) failWriting(errno);
}

void OutputFile::write(const std::string& text) { write(std::as_bytes(std::span(text))); }

void OutputFile::failWriting(int error) const {
  failRunning(std::string("writing failed: ") + std::strerror(error), path_.string(), adviceOn(error));
}

int OutputFile::linkTo(const fs::path& name) const {
  const std::string source = nameOf(descriptor_);
  return linkat(AT_FDCWD, source.c_str(), AT_FDCWD, name.c_str(), AT_SYMLINK_FOLLOW) == 0 ? 0 : errno;
}

bool OutputFile::commitNameless() {
  const StopDelay delay;
  const int error = linkTo(path_);
  if (error == EEXIST) return false;
  if (error != 0) failWriting(error);
  noteWritten(delay, path_);
  return true;
}

void OutputFile::commit() {
  if (fsync(descriptor_) != 0) failWriting(errno);
  if (!isNamed_) {
    if (commitNameless()) return;
    // Only a file that has a name can take an older one's place.
    const int error = takeName([this](const fs::path& name) { return linkTo(name); });
    if (error != 0) failWriting(error);
  }
  const StopDelay delay;
  if (std::rename(temporary_.c_str(), path_.c_str()) != 0) failWriting(errno);
  noteTemporaryGone(delay, temporary_);
  noteWritten(delay, path_);
  isNamed_ = false;
}

}  // namespace havs
