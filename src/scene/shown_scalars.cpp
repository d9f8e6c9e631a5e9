#include "scene/shown_scalars.h"

#include <algorithm>

namespace havs {

ShownScalars::ShownScalars(const ExtinctionCurve& curve) : ShownScalars(curve, true, {}) {}

/// A piece between two knots shows something inside where it does at either of them. Opaque surfaces need no interval
/// of their own: extinction is as large as it goes there (makeCurve).
ShownScalars::ShownScalars(const ExtinctionCurve& curve, bool volume, std::span<const ShownIsosurface> isosurfaces) {
  std::vector<Interval> pieces;
  const auto& knots = curve.knots;
  for (std::size_t i = 0; volume && i + 1 < knots.size(); ++i) {
    const ExtinctionCurve::Knot &a = knots[i], &b = knots[i + 1];
    const bool atLow = a.kappa > 0, atHigh = b.kappa > 0;
    if (!atLow && !atHigh) continue;
    const bool isStep = !(a.s < b.s);
    pieces.push_back({a.s, b.s, atLow || isStep, atHigh || isStep});
  }
  for (const ShownIsosurface& surface : isosurfaces)
    pieces.push_back({surface.scalar - kSurfaceMargin, surface.scalar + kSurfaceMargin, true, true});
  if (!isosurfaces.empty())
    std::stable_sort(pieces.begin(), pieces.end(), [](const Interval& a, const Interval& b) { return a.low < b.low; });
  join(std::move(pieces));
}

/// Ascending pieces that overlap, or touch in a scalar of either, become one.
void ShownScalars::join(std::vector<Interval> pieces) {
  for (const Interval& piece : pieces) {
    Interval* const last = intervals_.empty() ? nullptr : &intervals_.back();
    const bool joins =
        last != nullptr && (last->high > piece.low || (last->high == piece.low && (last->hasHigh || piece.hasLow)));
    if (!joins) {
      intervals_.push_back(piece);
      continue;
    }
    if (last->low == piece.low) last->hasLow = last->hasLow || piece.hasLow;
    if (last->high == piece.high) last->hasHigh = last->hasHigh || piece.hasHigh;
    if (last->high < piece.high) {
      last->high = piece.high;
      last->hasHigh = piece.hasHigh;
    }
  }
}

bool ShownScalars::meet(double low, double high) const {
  auto next = std::partition_point(intervals_.begin(), intervals_.end(),
                                   [low](const Interval& i) { return i.high < low || (i.high == low && !i.hasHigh); });
  return next != intervals_.end() && (next->low < high || (next->low == high && next->hasLow));
}

}  // namespace havs
