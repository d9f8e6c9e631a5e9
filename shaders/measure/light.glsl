// Emission only: the light that a segment sends out, attenuated by nothing.
#include "curve.glsl"
#include "core/exponential.glsl"
#include "core/integration.glsl"
#include "core/integral_functions.glsl"

Rgba lookUp(Segment segment) {
  Rgba light = meanLight(coverageOf(segment.scalarFront, segment.scalarBack));
  return Rgba(light.r * segment.length, light.g * segment.length, light.b * segment.length, Real(0.0));
}
