#include "reference/ray_color.h"

#include "transfer/pieces.h"
#include "transfer/preintegration.h"

namespace havs {
namespace {

using A = DoubleArithmetic;

/// Where a segment first meets an opaque interval.
struct Surface {
  double share = 2;  ///< of the way; > 1: nowhere
  double scalar = 0;
};

Surface firstSurface(const ExtinctionCurve& curve, double from, double to) {
  Surface surface;
  for (const auto& [low, high] : curve.opaque) {
    const double share = A::opaqueEntry(low, high, from, to);
    if (share < surface.share) surface = {share, std::clamp(from, low, high)};
  }
  return surface;
}

/// At a step of the curve, the side that is opaque.
Rgba colorOfSurface(const ExtinctionCurve& curve, double scalar) {
  ExtinctionCurve::Knot sample = curve.at(scalar);
  const auto first = std::lower_bound(curve.knots.begin(), curve.knots.end(), scalar,
                                      [](const ExtinctionCurve::Knot& k, double s) { return k.s < s; });
  for (auto knot = first; knot != curve.knots.end() && knot->s == scalar; ++knot)
    if (knot->kappa > sample.kappa) sample = *knot;
  return {sample.color[0], sample.color[1], sample.color[2], 1};
}

Rgba integrate(const ExtinctionCurve& curve, double from, double to, double length) {
  const SegmentColor c = integrateSegment(curve, from, to, length);
  return {c.color[0], c.color[1], c.color[2], c.alpha};
}

}  // namespace

RayColor rayColor(const ExtinctionCurve& curve, std::span<const CellSegment> segments) {
  Rgba sum(0, 0, 0, 0);
  for (const CellSegment& s : segments) {
    const double length = s.exit - s.entry;
    const Surface surface = firstSurface(curve, s.scalarEntry, s.scalarExit);
    if (surface.share <= 1) {
      sum = A::compositeUnder(sum, integrate(curve, s.scalarEntry, surface.scalar, surface.share * length));
      sum = A::compositeUnder(sum, colorOfSurface(curve, surface.scalar));
      break;
    }
    sum = A::compositeUnder(sum, integrate(curve, s.scalarEntry, s.scalarExit, length));
  }
  return {sum.r, sum.g, sum.b, sum.a};
}

}  // namespace havs
