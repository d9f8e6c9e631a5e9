// The transfer function along the scalar: colour and extinction (per local unit), evenly sampled, linear between
// samples.
#ifndef HAVS_CURVE
#define HAVS_CURVE
uniform sampler2D curve;
uniform vec2 curveScaleBias;  // half-texel correction: sample 0 at scalar 0, the last at 1

vec4 curveAt(float scalar) { return texture(curve, vec2(scalar * curveScaleBias.x + curveScaleBias.y, 0.5)); }
#endif
