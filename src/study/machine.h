#pragma once
#include <cstddef>
#include <string>

namespace havs {

/// Where something was measured.
struct Machine {
  std::string cpu;          ///< as /proc/cpuinfo names it
  int cores = 0;            ///< that the system offers to this process
  std::size_t threads = 0;  ///< that parallel loops use now
  std::size_t memoryBytes = 0;
  std::string system;    ///< kernel and its release
  std::string havs;      ///< version
  std::string compiler;  ///< that built it
};
Machine thisMachine();

}  // namespace havs
