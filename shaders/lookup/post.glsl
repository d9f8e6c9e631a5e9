// Post-classification: the transfer function at the segment's two ends, the trapezoid between them.
#include "curve.glsl"
#include "core/exponential.glsl"
#include "core/integration.glsl"

Rgba lookUp(Segment segment) {
  vec4 front = curveAt(segment.scalarFront);
  vec4 back = curveAt(segment.scalarBack);
  return trapezoidSegment(front, back, segment.length);
}
