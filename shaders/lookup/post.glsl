// Post-classification: the transfer function at the segment's two ends, the trapezoid between them.
#include "curve.glsl"
#include "core/exponential.glsl"
#include "core/integration.glsl"

Rgba lookUp(Segment segment) {
  return trapezoidSegment(curveAt(segment.scalarFront), curveAt(segment.scalarBack), segment.length);
}
