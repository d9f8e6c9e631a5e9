#include "scene/shown_scalars.h"

#include <algorithm>

namespace havs {

/// A piece between two knots shows something inside where it does at either of them. Opaque surfaces need no interval
/// of their own: extinction is as large as it goes there (makeCurve).
ShownScalars::ShownScalars(const ExtinctionCurve& curve) {
  const auto& knots = curve.knots;
  for (std::size_t i = 0; i + 1 < knots.size(); ++i) {
    const ExtinctionCurve::Knot &a = knots[i], &b = knots[i + 1];
    const bool atLow = a.kappa > 0, atHigh = b.kappa > 0;
    if (!atLow && !atHigh) continue;
    const bool isStep = !(a.s < b.s);
    const Interval piece{a.s, b.s, atLow || isStep, atHigh || isStep};
    Interval* const last = intervals_.empty() ? nullptr : &intervals_.back();
    if (last != nullptr && !(last->high < piece.low) && (last->hasHigh || piece.hasLow)) {
      last->high = piece.high;
      last->hasHigh = piece.hasHigh;
    } else {
      intervals_.push_back(piece);
    }
  }
}

bool ShownScalars::meet(double low, double high) const {
  auto next = std::partition_point(intervals_.begin(), intervals_.end(),
                                   [low](const Interval& i) { return i.high < low || (i.high == low && !i.hasHigh); });
  return next != intervals_.end() && (next->low < high || (next->low == high && next->hasLow));
}

}  // namespace havs
