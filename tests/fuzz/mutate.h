#pragma once
#include <cstdint>
#include <random>
#include <string>
#include <vector>

namespace havs::fuzz {

using Random = std::mt19937_64;

/// One of the inputs with one to four changes: a bit, a byte, a number that readers may trip over, a piece cut out,
/// doubled or of another input, or its end cut off. The same for the same random numbers on every machine.
std::string mutated(const std::vector<std::string>& inputs, Random& random);

}  // namespace havs::fuzz
