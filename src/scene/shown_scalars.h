#pragma once
#include <span>
#include <vector>

#include "scene/isosurface.h"
#include "transfer/extinction_curve.h"

namespace havs {

/// Which parts of a scene are drawn.
struct WhatShows {
  bool volume = true;
  bool isosurfaces = true;
};

/// The scalars at which anything shows: extinction above 0, or an opaque surface (both sides of a step count), or an
/// isosurface.
class ShownScalars {
 public:
  explicit ShownScalars(const ExtinctionCurve& curve);
  /// `volume`: whether the curve shows; the isosurfaces do, with kSurfaceMargin to both sides.
  ShownScalars(const ExtinctionCurve& curve, bool volume, std::span<const ShownIsosurface> isosurfaces);
  /// Whether it shows anything somewhere on [low, high], of [0, 1]; exact: ranges that only touch an interval in a
  /// scalar where extinction is 0 do not meet it. Logarithmic in the number of the curve's separate parts.
  bool meet(double low, double high) const;
  /// Whether there are none at all.
  bool empty() const { return intervals_.empty(); }

  /// A surface that lies next to a face of a cell may be found on its other side, in float: by an interpolation's
  /// rounding, some 2^-24 of the domain.
  static constexpr double kSurfaceMargin = 1e-6;

 private:
  struct Interval {
    double low, high;
    bool hasLow, hasHigh;  ///< its ends belong to it
  };
  void join(std::vector<Interval> pieces);

  std::vector<Interval> intervals_;  ///< ascending, disjoint
};

}  // namespace havs
