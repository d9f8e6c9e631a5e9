#include "study/machine.h"

#include <sys/utsname.h>
#include <unistd.h>

#include <fstream>
#include <thread>

#include "core/parallel.h"

namespace havs {
namespace {

std::string cpuName() {
  std::ifstream stream("/proc/cpuinfo");
  for (std::string line; std::getline(stream, line);)
    if (line.starts_with("model name")) {
      const std::size_t begin = line.find_first_not_of(" \t", line.find(':') + 1);
      if (begin != std::string::npos) return line.substr(begin);
    }
  return "unknown";
}

std::string systemName() {
  utsname name{};
  if (uname(&name) != 0) return "unknown";
  return std::string(name.sysname) + " " + name.release + " " + name.machine;
}

}  // namespace

Machine thisMachine() {
  Machine machine;
  machine.cpu = cpuName();
  machine.cores = static_cast<int>(std::thread::hardware_concurrency());
  machine.threads = threadCount();
  machine.memoryBytes =
      static_cast<std::size_t>(sysconf(_SC_PHYS_PAGES)) * static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
  machine.system = systemName();
  machine.havs = HAVS_VERSION;
  machine.compiler = std::string("g++ ") + __VERSION__;
  return machine;
}

}  // namespace havs
