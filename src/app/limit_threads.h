#pragma once
#include "core/parallel.h"

namespace havs {

/// Limits parallel loops for the rest of the process, 0: not at all. Never lifted: oneTBB would start the threads that
/// are allowed then, at the end, for nothing, and end the program where it cannot.
inline void limitThreads(std::size_t threads) {
  static const ThreadLimit& limit [[maybe_unused]] = *new ThreadLimit(threads);
}

}  // namespace havs
