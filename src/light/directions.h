#pragma once
#include <cstddef>
#include <vector>

#include "core/vec.h"

namespace havs {

/// `count` directions of length 1 that share the sphere evenly: direction i has z = 1 - (2 i + 1) / count and turns by
/// the golden angle from the last (spherical Fibonacci points; Marques et al. 2013, Spherical Fibonacci Point Sets for
/// Illumination Integrals).
std::vector<Vec3> fibonacciDirections(std::size_t count);

}  // namespace havs
