#pragma once
#include <cstddef>

namespace havs {

/// The largest resident size this process has had so far, in bytes (the system's own count).
std::size_t peakMemoryBytes();

/// Processor time, user and system, of all threads of this process so far, in seconds.
double cpuSeconds();

}  // namespace havs
