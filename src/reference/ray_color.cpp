#include "reference/ray_color.h"

#include "reference/ray_surface.h"
#include "transfer/pieces.h"
#include "transfer/preintegration.h"

namespace havs {
namespace {

using A = DoubleArithmetic;

Rgba integrate(const ExtinctionCurve& curve, double from, double to, double length) {
  const SegmentColor c = integrateSegment(curve, from, to, length);
  return {c.color[0], c.color[1], c.color[2], c.alpha};
}

}  // namespace

RayColor rayColor(const ExtinctionCurve& curve, std::span<const CellSegment> segments) {
  Rgba sum(0, 0, 0, 0);
  for (const CellSegment& s : segments) {
    const double length = s.exit - s.entry;
    const RaySurface surface = firstSurface(curve, s.scalarEntry, s.scalarExit);
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
