#include "core/progress.h"

#include <fmt/core.h>
#include <unistd.h>

#include <chrono>
#include <memory>
#include <string>

namespace havs {

Progress terminalProgress(bool quiet) {
  if (quiet || !isatty(STDERR_FILENO)) return {};
  using Clock = std::chrono::steady_clock;
  auto last = std::make_shared<Clock::time_point>();
  return [last](std::string_view stage, double fraction) {
    const auto now = Clock::now();
    const bool done = fraction >= 1.0;
    if (!done && now - *last < std::chrono::milliseconds(80)) return;
    *last = now;
    constexpr int kWidth = 30;
    const int filled = static_cast<int>(fraction * kWidth);
    fmt::print(stderr, "\r{:<12} [{}{}] {:3.0f}%", stage, std::string(filled, '='), std::string(kWidth - filled, ' '),
               100.0 * fraction);
    if (done) fmt::print(stderr, "\r{:<60}\r", "");
    std::fflush(stderr);
  };
}

}  // namespace havs
