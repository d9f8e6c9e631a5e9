#include "light/directions.h"

#include <cmath>
#include <numbers>

namespace havs {

std::vector<Vec3> fibonacciDirections(std::size_t count) {
  std::vector<Vec3> directions(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double z = 1 - (2 * static_cast<double>(i) + 1) / static_cast<double>(count);
    const double turns = static_cast<double>(i) / std::numbers::phi;
    const double angle = 2 * std::numbers::pi * (turns - std::floor(turns));
    const double radius = std::sqrt((1 - z) * (1 + z));
    directions[i] = {radius * std::cos(angle), radius * std::sin(angle), z};
  }
  return directions;
}

}  // namespace havs
