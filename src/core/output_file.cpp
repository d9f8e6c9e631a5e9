#include "core/output_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>

#include "core/error.h"

namespace havs {
namespace fs = std::filesystem;

OutputFile::OutputFile(fs::path path) : path_(std::move(path)) {
  std::error_code ignored;
  if (path_.filename().empty() || fs::is_directory(path_, ignored))
    failInput("the output is a directory", path_.string(), "name a file in it");
  const fs::path folder = path_.has_parent_path() ? path_.parent_path() : fs::path(".");
  if (!fs::is_directory(folder, ignored))
    failInput("the output's folder does not exist", folder.string(), "create it first");
  temporary_ = folder / ("." + path_.stem().string() + "." + std::to_string(getpid()) + path_.extension().string());
  const int file = open(temporary_.c_str(), O_CREAT | O_EXCL | O_WRONLY | O_CLOEXEC, 0666);
  if (file < 0 && errno != EEXIST)
    failInput(std::string("cannot write there: ") + std::strerror(errno), path_.string(), "choose another place");
  if (file >= 0) close(file);
}

OutputFile::~OutputFile() {
  std::error_code ignored;
  if (!committed_) fs::remove(temporary_, ignored);
}

void OutputFile::write(std::span<const std::byte> bytes) {
  std::ofstream stream(temporary_, std::ios::binary | std::ios::trunc);
  stream.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  stream.close();
  if (!stream) failRunning(std::string("writing failed: ") + std::strerror(errno), path_.string(), "is the disk full?");
}

void OutputFile::write(const std::string& text) { write(std::as_bytes(std::span(text))); }

void OutputFile::commit() {
  const int file = open(temporary_.c_str(), O_RDONLY | O_CLOEXEC);
  const bool flushed = file >= 0 && fsync(file) == 0;
  if (file >= 0) close(file);
  std::error_code error;
  if (flushed) fs::rename(temporary_, path_, error);
  if (!flushed || error)
    failRunning("writing failed: " + (error ? error.message() : std::string(std::strerror(errno))), path_.string(),
                "is the disk full?");
  committed_ = true;
}

}  // namespace havs
