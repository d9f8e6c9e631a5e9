#pragma once
#include <array>
#include <string>

namespace havs {

/// What to try where a library cannot be opened for `reason`, the words of dlerror(): `otherwise`, unless they say that
/// the process may not have the memory or the files, when nothing is to be installed.
inline std::string libraryAdvice(const std::string& reason, const std::string& otherwise) {
  constexpr std::array kSigns{"failed to map", "cannot allocate", "cannot map", "Too many open files"};
  for (const char* sign : kSigns)
    if (reason.find(sign) != std::string::npos) return "raise the limits (ulimit -v, -n)";
  return otherwise;
}

}  // namespace havs
