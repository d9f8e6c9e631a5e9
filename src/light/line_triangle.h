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

  /// The corners' shares in the point where the ray meets the triangle: at least 0, they add up to 1.
  std::array<double, 3> shares() const {
    const double sum = share[0] + share[1] + share[2];
    if (!(sum > 0)) return {1.0 / 3, 1.0 / 3, 1.0 / 3};
    const double scale = 1 / sum;
    return {share[0] * scale, share[1] * scale, share[2] * scale};
  }

  /// The ray entered a cell through this triangle; the cell's other corner is `apex`. Turns into the triangle that it
  /// leaves the cell through and returns the corner that this lacks; kNoIndex where there is none, which cannot be:
  /// round the four corners the signs of the sides are those of points of a plane about another (header).
  Index passCell(const LinePoint& apex) {
    const LineSide first = sideOf(corner[0], apex), second = sideOf(corner[1], apex);
    if (first.sign < 0 && second.sign > 0) return replace(2, first, second, apex);
    const LineSide third = sideOf(corner[2], apex);
    if (second.sign < 0 && third.sign > 0) return replace(0, second, third, apex);
    if (third.sign < 0 && first.sign > 0) return replace(1, third, first, apex);
    return kNoIndex;
  }

 private:
  /// `next` and `last`: the sides of the edges from the two corners after `dropped` to the apex.
  Index replace(std::size_t dropped, const LineSide& next, const LineSide& last, const LinePoint& apex) {
    const Index passed = corner[dropped].point;
    corner[dropped] = apex;
    share[(dropped + 1) % 3] = last.value;
    share[(dropped + 2) % 3] = -next.value;
    return passed;
  }
};

}  // namespace havs
