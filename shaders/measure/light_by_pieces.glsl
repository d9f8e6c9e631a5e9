// Emission only: the light that a segment sends out, attenuated by nothing, from piece to piece.
#include "curve.glsl"
#include "core/exponential.glsl"
#include "core/integration.glsl"
#include "core/integral_functions.glsl"
#include "core/piecewise.glsl"

Rgba lookUp(Segment segment) {
  Rgba light = meanLightByPieces(segment.scalarFront, segment.scalarBack);
  return Rgba(light.r * segment.length, light.g * segment.length, light.b * segment.length, Real(0.0));
}
