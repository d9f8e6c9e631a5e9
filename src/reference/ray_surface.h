#pragma once
#include "transfer/extinction_curve.h"
#include "transfer/pieces.h"

namespace havs {

/// Where a segment first meets an opaque interval of the curve.
struct RaySurface {
  double share = 2;  ///< of the way; > 1: nowhere
  double scalar = 0;
};
RaySurface firstSurface(const ExtinctionCurve& curve, double from, double to);

/// The colour of an opaque surface, of opacity 1: at a step of the curve that of the side that is opaque.
Rgba colorOfSurface(const ExtinctionCurve& curve, double scalar);

}  // namespace havs
