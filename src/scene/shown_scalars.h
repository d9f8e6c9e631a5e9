#pragma once
#include <vector>

#include "transfer/extinction_curve.h"

namespace havs {

/// The scalars at which a transfer function shows anything: extinction above 0, or an opaque surface. Both sides of a
/// step count.
class ShownScalars {
 public:
  explicit ShownScalars(const ExtinctionCurve& curve);
  /// Whether it shows anything somewhere on [low, high], of [0, 1]; exact: ranges that only touch an interval in a
  /// scalar where extinction is 0 do not meet it. Logarithmic in the number of the curve's separate parts.
  bool meet(double low, double high) const;
  /// Whether there are none at all.
  bool empty() const { return intervals_.empty(); }

 private:
  struct Interval {
    double low, high;
    bool hasLow, hasHigh;  ///< its ends belong to it
  };
  std::vector<Interval> intervals_;  ///< ascending, disjoint
};

}  // namespace havs
