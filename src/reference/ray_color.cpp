#include "reference/ray_color.h"

#include "reference/crossings.h"
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

/// Puts the volume of a stretch under `sum`; true where an opaque surface ends the ray.
bool addVolume(const ExtinctionCurve& curve, double from, double to, double length, Rgba& sum) {
  const RaySurface surface = firstSurface(curve, from, to);
  if (surface.share > 1) {
    sum = A::compositeUnder(sum, integrate(curve, from, to, length));
    return false;
  }
  sum = A::compositeUnder(sum, integrate(curve, from, surface.scalar, surface.share * length));
  sum = A::compositeUnder(sum, colorOfSurface(curve, surface));
  return true;
}

/// The same with an isosurface.
bool addSurface(const ShownIsosurface& surface, Rgba& sum) {
  const auto& [r, g, b] = surface.color;
  const double a = surface.opacity;
  sum = A::compositeUnder(sum, {a * r, a * g, a * b, a});
  return a >= 1;
}

/// Puts a layer under `sum`.
auto under(Rgba& sum) {
  return [&sum](const std::array<float, 4>& rgba) { sum = A::compositeUnder(sum, colorOfLayer(rgba)); };
}

}  // namespace

Rgba colorOfLayer(const std::array<float, 4>& rgba) {
  const auto& [r, g, b, a] = rgba;
  return {static_cast<double>(r), static_cast<double>(g), static_cast<double>(b), static_cast<double>(a)};
}

RayColor rayColor(const RayScene& scene, std::span<const CellSegment> segments) {
  Rgba sum(0, 0, 0, 0);
  Crossings crossings(scene.isosurfaces);
  LayersOfRay layers(scene.layers);
  for (const CellSegment& s : segments) {
    layers.before(middleOf(s), under(sum));
    const double length = s.exit - s.entry;
    double from = s.scalarEntry, begin = 0;
    bool ended = false;
    crossings.visit(s, [&](const ShownIsosurface& surface, double share) {
      ended = ended || addVolume(scene.curve, from, surface.scalar, (share - begin) * length, sum) ||
              addSurface(surface, sum);
      from = surface.scalar;
      begin = share;
    });
    if (ended || addVolume(scene.curve, from, s.scalarExit, (1 - begin) * length, sum)) break;
  }
  layers.rest(under(sum));
  return {sum.r, sum.g, sum.b, sum.a};
}

RayColor rayIsosurfaces(const RayScene& scene, std::span<const CellSegment> segments) {
  Rgba sum(0, 0, 0, 0);
  Crossings crossings(scene.isosurfaces);
  LayersOfRay layers(scene.layers);
  bool ended = false;
  for (const CellSegment& s : segments) {
    layers.before(middleOf(s), under(sum));
    crossings.visit(s, [&](const ShownIsosurface& surface, double) { ended = ended || addSurface(surface, sum); });
    if (ended) break;
  }
  layers.rest(under(sum));
  return {sum.r, sum.g, sum.b, sum.a};
}

}  // namespace havs
