#include "transfer/few_pieces.h"

namespace havs {
namespace {

using Knot = ExtinctionCurve::Knot;

/// A step at s = 1 has its upper side there alone: a piece that begins at 1.
bool endsWithStep(const ExtinctionCurve& curve) {
  const std::vector<Knot>& knots = curve.knots;
  return knots.size() > 1 && !(knots[knots.size() - 2].s < knots.back().s);
}

}  // namespace

int countFewPieces(const ExtinctionCurve& curve) {
  int count = endsWithStep(curve) ? 1 : 0;
  for (std::size_t i = 1; i < curve.knots.size(); ++i) {
    const double width = curve.knots[i].s - curve.knots[i - 1].s;
    if (!(width > 0)) continue;
    if (width < FewPieces::kNarrowest) return 0;
    ++count;
  }
  return count <= FewPieces::kMost ? count : 0;
}

FewPieces fewPieces(const ExtinctionCurve& curve) {
  FewPieces made;
  made.ends.fill(2);
  made.atZero.fill(0);
  made.halfSlope.fill(0);
  auto add = [&made](const Knot& from, double slope, double end) {
    const auto i = static_cast<std::size_t>(made.count++);
    made.ends[i] = static_cast<float>(end);
    made.atZero[i] = static_cast<float>(from.kappa - slope * from.s);
    made.halfSlope[i] = static_cast<float>(slope / 2);
  };
  for (std::size_t i = 1; i < curve.knots.size(); ++i) {
    const Knot &low = curve.knots[i - 1], &high = curve.knots[i];
    if (high.s > low.s) add(low, (high.kappa - low.kappa) / (high.s - low.s), high.s);
  }
  if (endsWithStep(curve)) add(curve.knots.back(), 0, 2);
  made.ends[static_cast<std::size_t>(made.count) - 1] = 2;
  return made;
}

}  // namespace havs
