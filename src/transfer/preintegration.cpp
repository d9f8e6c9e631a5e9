#include "transfer/preintegration.h"

#include "transfer/pieces.h"

namespace havs {

SegmentColor integrateSegment(const ExtinctionCurve& curve, double sFront, double sBack, double length) {
  const double from = std::clamp(sFront, 0.0, 1.0);
  const double to = std::clamp(sBack, 0.0, 1.0);
  Rgba sum(0, 0, 0, 0);
  if (from == to) {
    const ExtinctionCurve::Knot k = curve.at(from);
    const Rgba sample(k.color[0], k.color[1], k.color[2], k.kappa);
    sum = integratePiece(sample, sample, length);
  } else {
    const double whole = std::abs(to - from);
    visitPieces(curve, from, to, [&](const Rgba& front, const Rgba& back, double extent) {
      sum = DoubleArithmetic::compositeUnder(sum, integratePiece(front, back, extent / whole * length));
    });
  }
  return {{sum.r, sum.g, sum.b}, sum.a};
}

double firstOpaque(const ExtinctionCurve& curve, double sFront, double sBack) {
  constexpr double kNever = 2;
  double first = kNever;
  for (const auto& [low, high] : curve.opaque) {
    if (sFront >= low && sFront <= high) return 0;
    const double reached = sFront < low ? low : high;  // the end that a ray from sFront meets
    const double way = sBack - sFront;
    const bool ahead = way > 0 ? reached > sFront && reached <= sBack : reached < sFront && reached >= sBack;
    if (ahead) first = std::min(first, (reached - sFront) / way);
  }
  return first;
}

}  // namespace havs
