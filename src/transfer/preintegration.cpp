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
  double first = 2;  // never
  for (const auto& [low, high] : curve.opaque)
    first = std::min(first, Arithmetic<DoubleLane>::opaqueEntry(low, high, sFront, sBack));
  return first;
}

}  // namespace havs
