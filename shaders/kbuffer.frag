// Hardware-assisted visibility sorting (Callahan, Ikits, Comba, Silva 2005): faces arrive roughly near first; each fragment goes into the
// pixel's k-buffer, the nearest of k + 1 goes out, and the segment between it and the next nearest is looked up and composited.
// Reads and writes of a pixel are ordered by framebuffer fetch.
#include "core/language.glsl"
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
#endif

Fragment incomingFragment() {
  Fragment f;
#ifdef HAVS_CELL_DATA
  vec2 behind = faceScalars[faceOrder[gl_PrimitiveID]];
  f.scalar = gl_FrontFacing ? behind.x : behind.y;
#else
  f.scalar = clamp(scalar, 0.0, 1.0);
#endif
  vec2 slope = gl_FragCoord.xy * pixelToRay.xy + pixelToRay.zw;
  f.distance = depth * sqrt(1.0 + dot(slope, slope));
  f.kind = onBoundary < 0.5 ? 0.0 : gl_FrontFacing ? 1.0 : -1.0;
  return f;
}

void main() {
  Rgba color;
  PixelState state;
  loadPixel(color, state);
#ifdef HAVS_EARLY_TERMINATION
  if (color.a >= terminalOpacity) discard;
#endif
  KBuffer buffer = loadEntries();
  Fragment incoming = incomingFragment();

#ifndef HAVS_COMPOSITE_LATE
  if (isLate(buffer, state, incoming)) {
    state.inside += incoming.kind;
    storePixel(color, state);
    return;
  }
#endif
  Fragment front;
  insertFragment(buffer, incoming, front);
  Segment segment = leave(state, front, buffer.entry[0]);
  storePixel(compositeUnder(color, segmentColor(segment)), state);
  storeEntries(buffer);
}
