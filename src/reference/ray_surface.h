#pragma once
#include <array>

#include "transfer/extinction_curve.h"
#include "transfer/pieces.h"

namespace havs {

/// Where a segment first meets an opaque interval of the curve.
struct RaySurface {
  double share = 2;  ///< of the way; > 1: nowhere
  double scalar = 0;
  std::array<double, 2> interval{};  ///< that is met
};
RaySurface firstSurface(const ExtinctionCurve& curve, double from, double to);

/// The colour of an opaque surface, of opacity 1: at a step of the curve that of the side within the interval; of an
/// interval of one number, the first of the densest.
Rgba colorOfSurface(const ExtinctionCurve& curve, const RaySurface& surface);

}  // namespace havs
