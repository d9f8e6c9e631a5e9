// X-ray: the optical depth of a segment, in the fourth number. Depths add up in any order.
#include "curve.glsl"
#include "core/exponential.glsl"
#include "core/integration.glsl"
#include "core/integral_functions.glsl"
#include "opaque_depth.glsl"

Rgba lookUp(Segment segment) {
  Real depth = meanExtinction(coverageOf(segment.scalarFront, segment.scalarBack)) * segment.length;
  if (opaqueSurfaces) depth = depth + depthOfSurface(segment);
  return Rgba(Real(0.0), Real(0.0), Real(0.0), depth);
}
