// The fragment of a face that faces.vert has sent: scalar, distance along the pixel's ray, kind. Include it after
// payload.glsl and core/kbuffer.glsl.
smooth in float scalar;
smooth in float depth;
flat in float onBoundary;

uniform vec4 pixelToRay;  // xy scale and zw offset from window coordinates to the ray's slope; zero for parallel rays
#ifdef HAVS_CELL_DATA
// Per face, in drawing order: the scalars of the cells behind it as seen from its front and from its back.
layout(std430, binding = 0) readonly buffer FaceScalars { vec2 faceScalars[]; };
layout(std430, binding = 1) readonly buffer FaceOrder { uint faceOrder[]; };
uniform int firstFace;  // of the batch
#endif

Fragment incomingFragment() {
#ifdef HAVS_CELL_DATA
  vec2 sides = faceScalars[faceOrder[firstFace + gl_PrimitiveID]];
  float behind = gl_FrontFacing ? sides.x : sides.y;
#else
  float behind = clamp(scalar, 0.0, 1.0);
#endif
  vec2 slope = gl_FragCoord.xy * pixelToRay.xy + pixelToRay.zw;
  float distance = depth * sqrt(1.0 + dot(slope, slope));
  return makeFragment(behind, distance, onBoundary < 0.5 ? 0.0 : gl_FrontFacing ? 1.0 : -1.0);
}
