#pragma once
#include <cstdio>
#include <memory>

namespace havs {

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
/// A file of C's library, for libraries in C; closed with the pointer.
using FilePointer = std::unique_ptr<std::FILE, CloseFile>;

}  // namespace havs
