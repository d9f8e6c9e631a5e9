#pragma once
// From a case that fails to a small one that fails.
#include <functional>

#include "hard/random_case.h"

namespace havs::test {

/// Whether a case fails in the way that is looked for.
using Fails = std::function<bool(const RandomCase&)>;

/// The smallest case found with `mostTries` calls of `fails`: fewer cells, fewer settings, fewer points of the transfer
/// function, a smaller picture, numbers of fewer digits.
RandomCase shrunk(RandomCase c, const Fails& fails, int mostTries = 600);

}  // namespace havs::test
