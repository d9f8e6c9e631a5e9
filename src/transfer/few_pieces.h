#pragma once
#include <array>

#include "transfer/extinction_curve.h"

namespace havs {

/// Extinction over [0, 1] where few pieces make it up, none of them narrow: their numbers fit into registers, so that
/// a mean takes no table (shaders/measure/optical_depth_of_few_pieces.glsl).
struct FewPieces {
  static constexpr int kMost = 8;
  /// Steps have no width. Narrower pieces than this would lose digits, as a piece's line is taken from s = 0.
  static constexpr double kNarrowest = 1.0 / 16;
  int count = 0;
  std::array<float, kMost> ends;       ///< where each piece ends, ascending; of the last one, beyond 1
  std::array<float, kMost> atZero;     ///< kappa, per local unit, where the piece's line comes to s = 0
  std::array<float, kMost> halfSlope;  ///< half of its change per unit of s
};

/// Of how many pieces a curve is made; 0: of too many, or of narrow ones.
int countFewPieces(const ExtinctionCurve& curve);

/// The pieces of a curve that has few.
FewPieces fewPieces(const ExtinctionCurve& curve);

}  // namespace havs
