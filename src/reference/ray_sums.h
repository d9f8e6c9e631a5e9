#pragma once
// What a ray gathers in modes that composite nothing, in double: the ground truth of each (docs/03-scene.md, Modes).
#include <span>

#include "reference/cell_segments.h"
#include "reference/ray_color.h"
#include "transfer/extinction_curve.h"

namespace havs {

/// Black of opacity 1 - exp(-integral of kappa); 1 behind an opaque surface.
RayColor rayAbsorption(const RayScene& scene, std::span<const CellSegment> segments);
/// The integral of colour times kappa, at most 1, of opacity 0. Opaque surfaces do not shine: kappa is bridged over
/// them (withoutOpaque).
RayColor rayEmission(const RayScene& scene, std::span<const CellSegment> segments);
/// The colour of the greatest, of the least and of the mean scalar, of opacity 1; transparent for a ray that meets
/// nothing.
RayColor rayMaximum(const RayScene& scene, std::span<const CellSegment> segments);
RayColor rayMinimum(const RayScene& scene, std::span<const CellSegment> segments);
RayColor rayAverage(const RayScene& scene, std::span<const CellSegment> segments);

/// The curve's colour at a scalar of [0, 1], opaque.
RayColor opaqueColor(const ExtinctionCurve& curve, double scalar);

}  // namespace havs
