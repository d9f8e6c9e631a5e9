// Hardware-assisted visibility sorting (Callahan, Ikits, Comba, Silva 2005): faces arrive roughly near first; each
// fragment goes into the pixel's k-buffer, the nearest of k + 1 goes out, and the segment between it and the next
// nearest is looked up and composited. Reads and writes of a pixel are ordered by framebuffer fetch.
#include "core/language.glsl"
#include "payload.glsl"
#include "core/kbuffer.glsl"
#include "core/compositing.glsl"
#include "kbuffer_targets.glsl"
#include "segment_color.glsl"

smooth in float scalar;
smooth in float depth;
flat in float onBoundary;

uniform vec4 pixelToRay;  // xy scale and zw offset from window coordinates to the ray's slope; zero for parallel rays
#ifdef HAVS_EARLY_TERMINATION
uniform float terminalOpacity;
#endif
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

void main() {
  Rgba color;
  PixelState state;
  loadPixel(color, state);
#ifdef HAVS_EARLY_TERMINATION
  if (color.a >= terminalOpacity) discard;
#endif
  KBuffer kbuffer = loadEntries();
  Fragment incoming = incomingFragment();

#ifndef HAVS_COMPOSITE_LATE
  if (isLate(kbuffer, state, incoming)) {
    state.inside += kindOf(incoming.payload);
    storePixel(color, state);
    return;
  }
#endif
  Fragment front;
  insertFragment(kbuffer, incoming, front);
  Segment segment = leave(state, front, kbuffer.entry[0]);
  storePixel(compositeUnder(color, segmentColor(segment)), state);
  storeEntries(kbuffer);
}
