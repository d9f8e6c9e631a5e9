#pragma once
#include <array>
#include <cstddef>

#include "light/line_frame.h"

namespace havs {

/// A triangle that a ray goes through: its corners turn right-handed about the ray, with their shares, up to a common
/// factor, in the point where the ray meets it. Edge i lies opposite to corner i.
struct LineTriangle {
  std::array<LinePoint, 3> corner;
  std::array<double, 3> share;  ///< >= 0

  /// Whether the ray goes through a triangle of this sense; shares are written if so.
  bool isHit() {
    for (std::size_t i = 0; i < 3; ++i) {
      const LineSide side = sideOf(corner[(i + 1) % 3], corner[(i + 2) % 3]);
      if (side.sign <= 0) return false;
      share[i] = side.value;
    }
    return true;
  }

  /// The mean of the corners' values of something where the ray meets the triangle: between the least and greatest.
  double mean(double a, double b, double c) const {
    const double sum = share[0] + share[1] + share[2];
    if (!(sum > 0)) return (a + b + c) / 3;
    return (share[0] * a + share[1] * b + share[2] * c) / sum;
  }
  double along() const { return mean(corner[0].along, corner[1].along, corner[2].along); }

  /// The ray entered a cell through this triangle; the cell's other corner is `apex`. Turns into the triangle that it
  /// leaves the cell through and returns the corner that this lacks; kNoIndex where there is none, which cannot be:
  /// round the four corners the signs of the sides are those of points of a plane about another (header).
  Index passCell(const LinePoint& apex) {
    std::array<LineSide, 3> side;
    for (std::size_t i = 0; i < 3; ++i) side[i] = sideOf(corner[i], apex);
    for (std::size_t dropped = 0; dropped < 3; ++dropped) {
      const std::size_t i = (dropped + 1) % 3, j = (dropped + 2) % 3;
      if (side[i].sign >= 0 || side[j].sign <= 0) continue;
      const Index left = corner[dropped].point;
      corner[dropped] = apex;
      share[i] = side[j].value;
      share[j] = -side[i].value;
      return left;
    }
    return kNoIndex;
  }
};

}  // namespace havs
