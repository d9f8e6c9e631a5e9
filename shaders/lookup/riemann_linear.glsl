// A Riemann sum over the segment, the opacity of each step in proportion to its length.
#include "curve.glsl"
#include "core/exponential.glsl"
#include "core/integration.glsl"
#include "core/riemann.glsl"

Rgba lookUp(Segment segment) {
  return riemannLinearSegment(segment.scalarFront, segment.scalarBack, segment.length, lookupNumber);
}
