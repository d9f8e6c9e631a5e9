#pragma once
#include <functional>
#include <string_view>

namespace havs {

/// Told from long work how far it is: the stage's name and the fraction done, 0 to 1. May be empty. Called from one
/// thread at a time.
using Progress = std::function<void(std::string_view stage, double fraction)>;

/// A progress bar on standard error; silent when standard error is not a terminal or `quiet` is set.
Progress terminalProgress(bool quiet);

}  // namespace havs
