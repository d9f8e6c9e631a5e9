#include "reference/ray_sums.h"

#include <algorithm>
#include <cmath>

#include "transfer/pieces.h"
#include "transfer/preintegration.h"

namespace havs {
namespace {

/// Calls visit(atStart, atEnd, length) for the pieces of a segment on which (r, g, b, kappa) is linear.
template <class Visit>
void visitSegment(const ExtinctionCurve& curve, const CellSegment& s, const Visit& visit) {
  const double from = std::clamp(s.scalarEntry, 0.0, 1.0), to = std::clamp(s.scalarExit, 0.0, 1.0);
  const double length = s.exit - s.entry;
  if (from == to) {
    const ExtinctionCurve::Knot k = curve.at(from);
    const Rgba sample(k.color[0], k.color[1], k.color[2], k.kappa);
    visit(sample, sample, length);
    return;
  }
  const double perScalar = length / std::abs(to - from);
  visitPieces(curve, from, to,
              [&](const Rgba& front, const Rgba& back, double extent) { visit(front, back, extent * perScalar); });
}

template <class Better>
RayColor extreme(const ExtinctionCurve& curve, std::span<const CellSegment> segments, const Better& better) {
  if (segments.empty()) return {0, 0, 0, 0};
  double found = segments.front().scalarEntry;
  for (const CellSegment& s : segments) found = better(found, better(s.scalarEntry, s.scalarExit));
  return opaqueColor(curve, found);
}

}  // namespace

RayColor opaqueColor(const ExtinctionCurve& curve, double scalar) {
  const ExtinctionCurve::Knot k = curve.at(std::clamp(scalar, 0.0, 1.0));
  return {k.color[0], k.color[1], k.color[2], 1};
}

RayColor rayAbsorption(const RayScene& scene, std::span<const CellSegment> segments) {
  double depth = 0;
  for (const CellSegment& s : segments) {
    if (firstOpaque(scene.curve, s.scalarEntry, s.scalarExit) <= 1) return {0, 0, 0, 1};
    visitSegment(scene.curve, s, [&](const Rgba& front, const Rgba& back, double length) {
      depth += 0.5 * (front.a + back.a) * length;
    });
  }
  return {0, 0, 0, -std::expm1(-depth)};
}

RayColor rayEmission(const RayScene& scene, std::span<const CellSegment> segments) {
  const ExtinctionCurve& curve = scene.curve;
  const ExtinctionCurve seen = curve.opaque.empty() ? ExtinctionCurve{} : withoutOpaque(curve);
  RayColor sum{0, 0, 0, 0};
  for (const CellSegment& s : segments)
    visitSegment(curve.opaque.empty() ? curve : seen, s, [&](const Rgba& front, const Rgba& back, double length) {
      const double first = (2 * front.a + back.a) * length / 6, second = (front.a + 2 * back.a) * length / 6;
      sum[0] += first * front.r + second * back.r;
      sum[1] += first * front.g + second * back.g;
      sum[2] += first * front.b + second * back.b;
    });
  for (double& channel : sum) channel = std::min(channel, 1.0);
  return sum;
}

RayColor rayMaximum(const RayScene& scene, std::span<const CellSegment> segments) {
  return extreme(scene.curve, segments, [](double a, double b) { return std::max(a, b); });
}

RayColor rayMinimum(const RayScene& scene, std::span<const CellSegment> segments) {
  return extreme(scene.curve, segments, [](double a, double b) { return std::min(a, b); });
}

RayColor rayAverage(const RayScene& scene, std::span<const CellSegment> segments) {
  double sum = 0, length = 0;
  for (const CellSegment& s : segments) {
    sum += 0.5 * (s.scalarEntry + s.scalarExit) * (s.exit - s.entry);
    length += s.exit - s.entry;
  }
  return length > 0 ? opaqueColor(scene.curve, sum / length) : RayColor{0, 0, 0, 0};
}

}  // namespace havs
