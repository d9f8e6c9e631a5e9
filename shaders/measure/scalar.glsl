// Average: the integral of the scalar over a segment, and its length; the pixel's mean is one over the other.
#include "core/limits.glsl"

Rgba lookUp(Segment segment) {
  Real mean = Real(0.5) * (segment.scalarFront + segment.scalarBack);
  return Rgba(mean * segment.length, segment.length, Real(0.0), Real(0.0));
}
