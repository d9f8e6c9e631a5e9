#pragma once
// The resident memory of this process, as Linux counts it.
#include <cstddef>
#include <fstream>
#include <string>

namespace havs::test {

/// The value of a line of /proc/self/status ("VmRSS:", "VmHWM:") in bytes; 0 where there is none.
inline std::size_t statusBytes(const std::string& wanted) {
  std::ifstream status("/proc/self/status");
  for (std::string name; status >> name;)
    if (name == wanted) {
      std::size_t kilobytes = 0;
      status >> kilobytes;
      return kilobytes * 1024;
    }
  return 0;
}

inline std::size_t residentBytes() { return statusBytes("VmRSS:"); }
/// The most since resetPeak, or since the process began.
inline std::size_t peakResidentBytes() { return statusBytes("VmHWM:"); }
inline void resetPeak() { std::ofstream("/proc/self/clear_refs") << "5"; }

}  // namespace havs::test
