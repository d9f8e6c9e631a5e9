#include "reference/ray_surface.h"

#include <algorithm>

namespace havs {

RaySurface firstSurface(const ExtinctionCurve& curve, double from, double to) {
  RaySurface surface;
  for (const auto& interval : curve.opaque) {
    const auto [low, high] = interval;
    const double share = DoubleArithmetic::opaqueEntry(low, high, from, to);
    if (share < surface.share) surface = {share, std::clamp(from, low, high), interval};
  }
  return surface;
}

Rgba colorOfSurface(const ExtinctionCurve& curve, const RaySurface& surface) {
  const auto [low, high] = surface.interval;
  const auto first = std::lower_bound(curve.knots.begin(), curve.knots.end(), surface.scalar,
                                      [](const ExtinctionCurve::Knot& k, double s) { return k.s < s; });
  ExtinctionCurve::Knot sample = curve.at(surface.scalar);  // at a step, of its upper side
  const bool onKnot = first != curve.knots.end() && first->s == surface.scalar;
  if (onKnot && surface.scalar == high) sample = *first;  // of its lower side
  if (low == high)
    for (auto knot = first; knot != curve.knots.end() && knot->s == surface.scalar; ++knot)
      if (knot->kappa > sample.kappa) sample = *knot;
  return {sample.color[0], sample.color[1], sample.color[2], 1};
}

}  // namespace havs
