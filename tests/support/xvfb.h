#pragma once
#include <sys/types.h>

#include <optional>
#include <string>

namespace havs {

/// An X server without a screen, on a display that is free, for as long as it lives; DISPLAY names it meanwhile.
class Xvfb {
 public:
  /// Throws std::runtime_error where there is none (package xvfb) or it gives no display within 20 s.
  Xvfb();
  ~Xvfb();
  Xvfb(const Xvfb&) = delete;
  Xvfb& operator=(const Xvfb&) = delete;

 private:
  pid_t pid_ = -1;
  std::optional<std::string> formerDisplay_;
};

}  // namespace havs
