#pragma once
#include <array>
#include <span>

#include "reference/cell_segments.h"
#include "scene/isosurface.h"
#include "scene/ray_layers.h"
#include "transfer/extinction_curve.h"
#include "transfer/pieces.h"

namespace havs {

/// What a ray gathers: premultiplied colour and opacity.
using RayColor = std::array<double, 4>;

/// What a ray runs through, beside the cells.
struct RayScene {
  const ExtinctionCurve& curve;
  std::span<const ShownIsosurface> isosurfaces = {};  ///< ascending by scalar
  std::span<const RayLayer> layers = {};              ///< near first; for rays that composite
};

/// From the segments of a ray, in its order, to its premultiplied colour and opacity.
using RayFunction = RayColor (*)(const RayScene& scene, std::span<const CellSegment> segments);

/// The segments' exact integrals (integrateSegment) and the isosurfaces that they cross, composited front to back, up
/// to the first opaque surface: with it the ray ends with opacity 1. Layers between segments (RayLayers). Where a
/// segment comes to an opaque scalar and to an isosurface of the same value, the isosurface is behind.
RayColor rayColor(const RayScene& scene, std::span<const CellSegment> segments);

/// The isosurfaces and the layers alone.
RayColor rayIsosurfaces(const RayScene& scene, std::span<const CellSegment> segments);

Rgba colorOfLayer(const std::array<float, 4>& rgba);
/// Where layers behind it come after a segment.
inline double middleOf(const CellSegment& segment) { return 0.5 * (segment.entry + segment.exit); }

}  // namespace havs
