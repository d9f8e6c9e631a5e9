#pragma once
// What float and the order of fragments that lie closer than it can tell may make of a ray.
#include <span>

#include "reference/ray_color.h"

namespace havs::test {

/// How far the numbers of a fragment may be off, local units.
struct FragmentErrors {
  double scalar;
  double distance;
  double together;  ///< fragments no farther apart may come in any order
};

/// By how much the ray's colour may move, in the worst channel: the sum over its fragments of what each does when its
/// scalar or its distance moves by that much, or when it changes places with those it cannot be told from.
double floatEffect(const RayScene& scene, RayFunction function, std::span<const CellSegment> segments, bool cellData,
                   const FragmentErrors& errors);

/// By how much the ray's colour moves, in the worst channel, when what lies before `distance` is left out of it.
double cutEffect(const RayScene& scene, RayFunction function, std::span<const CellSegment> segments, double distance);

}  // namespace havs::test
