#include "mesh/file_blocks.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>

#include "core/error.h"
#include "core/memory_budget.h"
#include "core/parallel.h"

namespace havs {

FileBlocks::FileBlocks(const std::filesystem::path& file)
    : name_(file.string()), file_(open(file.c_str(), O_RDONLY | O_CLOEXEC)) {
  struct stat status {};
  if (file_ >= 0 && fstat(file_, &status) == 0 && S_ISREG(status.st_mode)) {
    size_ = static_cast<std::size_t>(status.st_size);
    return;
  }
  if (file_ >= 0) close(file_);
  failInput("cannot be read", file.string(), "check that it exists and its permissions");
}

FileBlocks::~FileBlocks() { close(file_); }

bool FileBlocks::read(std::size_t offset, std::span<char> bytes) const {
  while (!bytes.empty()) {
    const ssize_t length = pread(file_, bytes.data(), bytes.size(), static_cast<off_t>(offset));
    if (length < 0 && errno == EINTR) continue;
    if (length <= 0) return false;
    offset += static_cast<std::size_t>(length);
    bytes = bytes.subspan(static_cast<std::size_t>(length));
  }
  return true;
}

FileText::FileText(const std::filesystem::path& file) {
  const FileBlocks blocks(file);
  size_ = blocks.size();
  needMemory(static_cast<double>(size_), "its text", file.string(), "convert it to .vtu, which is read in pieces");
  text_ = std::make_unique_for_overwrite<char[]>(size_);
  constexpr std::size_t kBytesOfBlock = 1 << 20;
  std::atomic<bool> whole = true;
  parallelBlocks(0, size_, kBytesOfBlock, [&](std::size_t first, std::size_t last) {
    if (!blocks.read(first, std::span(text_.get() + first, last - first))) whole = false;
  });
  if (!whole) failInput("cannot be read to its end", file.string(), "check the disk and permissions");
}

}  // namespace havs
