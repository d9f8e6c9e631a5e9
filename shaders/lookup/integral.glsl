// Extinction and light by their integral functions over the scalar; light is not attenuated inside the segment.
#include "curve.glsl"
#include "core/exponential.glsl"
#include "core/integration.glsl"
#include "core/integral_functions.glsl"

Rgba lookUp(Segment segment) { return integralSegment(segment.scalarFront, segment.scalarBack, segment.length); }
