// X-ray: the optical depth of a segment, in the fourth number. Depths add up in any order; where the scalar comes to an
// opaque surface nothing is seen through any more.
#include "curve.glsl"
#include "core/exponential.glsl"
#include "core/integration.glsl"
#include "core/integral_functions.glsl"
#define HAVS_MEASURES_SURFACES
#ifdef HAVS_OPAQUE_SURFACES
#include "opaque_intervals.glsl"

Real depthOfSurface(Segment segment) {
  return select(firstOpaque(segment.scalarFront, segment.scalarBack).share <= Real(1.0), Real(kDepthLimit), Real(0.0));
}
#else
Real depthOfSurface(Segment segment) { return Real(0.0); }
#endif

Rgba lookUp(Segment segment) {
  Real depth = meanExtinction(coverageOf(segment.scalarFront, segment.scalarBack)) * segment.length;
  if (opaqueSurfaces) depth = depth + depthOfSurface(segment);
  return Rgba(Real(0.0), Real(0.0), Real(0.0), depth);
}
