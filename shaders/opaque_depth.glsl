#pragma once
// Where the scalar of a segment comes to an opaque surface, nothing is seen through any more.
#define HAVS_MEASURES_SURFACES
#ifdef HAVS_OPAQUE_SURFACES
#include "opaque_intervals.glsl"

Real depthOfSurface(Segment segment) {
  return select(firstOpaque(segment.scalarFront, segment.scalarBack).share <= Real(1.0), Real(kDepthLimit), Real(0.0));
}
#else
Real depthOfSurface(Segment segment) { return Real(0.0); }
#endif

