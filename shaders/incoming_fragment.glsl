// The fragment of a face that faces.vert has sent: what it carries (payload.glsl), distance along the pixel's ray,
// kind. Include it after payload.glsl and core/kbuffer.glsl.
smooth in float scalar;
flat in float cornerScalar;
smooth in float depth;
flat in float onBoundary;
#ifdef HAVS_COLOR_PAYLOAD
smooth in vec4 colorAndExtinction;
#endif

#ifdef HAVS_LIT
#include "incoming_light.glsl"
#endif

uniform vec4 pixelToRay;  // xy scale and zw offset from window coordinates to the ray's slope; zero for parallel rays
#ifdef HAVS_CELL_DATA
// Per face, in drawing order: the scalars (colours) of the cells behind it as seen from its front and from its back.
#ifdef HAVS_COLOR_PAYLOAD
layout(std430, binding = 0) readonly buffer FaceColors { vec4 faceColors[]; };
#else
layout(std430, binding = 0) readonly buffer FaceScalars { vec2 faceScalars[]; };
#endif
layout(std430, binding = 1) readonly buffer FaceOrder { uint faceOrder[]; };
uniform int firstFace;  // of the batch
#endif

// Scalars that are the same at all corners of a face come out of the interpolation some roundings off, which would take
// them to the other side of a step there.
const float kInterpolation = 5.0e-7;  // of the scalar

float incomingScalar() {
#ifdef HAVS_COLOR_PAYLOAD
  return 0.0;
#elif defined(HAVS_CELL_DATA)
  vec2 sides = faceScalars[faceOrder[firstFace + gl_PrimitiveID]];
  return gl_FrontFacing ? sides.x : sides.y;
#else
  return abs(scalar - cornerScalar) <= kInterpolation * cornerScalar ? cornerScalar : clamp(scalar, 0.0, 1.0);
#endif
}

#ifdef HAVS_COLOR_PAYLOAD
Payload incomingPayload(float kind, vec2 slope) {
#ifdef HAVS_CELL_DATA
  uint face = faceOrder[firstFace + gl_PrimitiveID];
  return makeColorPayload(faceColors[2u * face + (gl_FrontFacing ? 0u : 1u)], kind);
#else
  return makeColorPayload(colorAndExtinction, kind);
#endif
}
#elif defined(HAVS_LIT)
Payload incomingPayload(float kind, vec2 slope) {
  return makeLitPayload(incomingScalar(), kind, incomingLight(slope), incomingDensity());
}
#else
Payload incomingPayload(float kind, vec2 slope) { return makePayload(incomingScalar(), kind); }
#endif

Fragment incomingFragment() {
  vec2 slope = gl_FragCoord.xy * pixelToRay.xy + pixelToRay.zw;
  Fragment f;
  f.distance = depth * sqrt(1.0 + dot(slope, slope));
  f.payload = incomingPayload(onBoundary < 0.5 ? 0.0 : gl_FrontFacing ? 1.0 : -1.0, slope);
  return f;
}
