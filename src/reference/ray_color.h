#pragma once
#include <array>
#include <span>

#include "reference/cell_segments.h"
#include "transfer/extinction_curve.h"

namespace havs {

/// What a ray gathers: premultiplied colour and opacity.
using RayColor = std::array<double, 4>;

/// The segments' exact integrals (integrateSegment) composited front to back, up to the first opaque surface, whose
/// colour ends the ray with opacity 1. `segments` in the order of the ray.
RayColor rayColor(const ExtinctionCurve& curve, std::span<const CellSegment> segments);

}  // namespace havs
