#include "reference/ray_surface.h"

#include <algorithm>

namespace havs {

RaySurface firstSurface(const ExtinctionCurve& curve, double from, double to) {
  RaySurface surface;
  for (const auto& [low, high] : curve.opaque) {
    const double share = DoubleArithmetic::opaqueEntry(low, high, from, to);
    if (share < surface.share) surface = {share, std::clamp(from, low, high)};
  }
  return surface;
}

Rgba colorOfSurface(const ExtinctionCurve& curve, double scalar) {
  ExtinctionCurve::Knot sample = curve.at(scalar);
  const auto first = std::lower_bound(curve.knots.begin(), curve.knots.end(), scalar,
                                      [](const ExtinctionCurve::Knot& k, double s) { return k.s < s; });
  for (auto knot = first; knot != curve.knots.end() && knot->s == scalar; ++knot)
    if (knot->kappa > sample.kappa) sample = *knot;
  return {sample.color[0], sample.color[1], sample.color[2], 1};
}

}  // namespace havs
