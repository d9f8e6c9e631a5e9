#pragma once
#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace havs {

/// The order of accuracy: error = constant * size^slope over a range of sizes.
struct OrderFit {
  double slope = 0;                  ///< of log(error) against log(size), least squares
  std::array<double, 2> used{0, 0};  ///< least and greatest size of the range
  double worstFactor = 1;            ///< how far a point of the range lies from the line, as a factor
};

/// Fits (size, error) pairs. The range is chosen so: points whose error is less than ten times `floor` (what the other
/// sources of error leave: the error of a method without a table; 0: not known) are left out, and so are the finest
/// points as long as the error falls there less than half as steeply as it does at its steepest. Of what is left the
/// longest run of at least three neighbouring sizes is taken whose points lie within a factor of 1.25 of their line;
/// of equally long ones the finest. None: no such run. Sizes and errors must be positive; others are left out.
std::optional<OrderFit> fitOrder(std::span<const std::array<double, 2>> points, double floor);

}  // namespace havs
