// Hardware-assisted visibility sorting (Callahan, Ikits, Comba, Silva 2005): faces arrive roughly near first; each
// fragment goes into the pixel's k-buffer, the nearest of k + 1 goes out, and the segment between it and the next
// nearest is looked up and composited. Reads and writes of a pixel are ordered by framebuffer fetch.
#include "core/language.glsl"
#include "payload.glsl"
#include "core/kbuffer.glsl"
#include "core/compositing.glsl"
#include "kbuffer_targets.glsl"
#include "segment_color.glsl"
#include "layers.glsl"
#include "incoming_fragment.glsl"
#include "certificate.glsl"

#ifdef HAVS_EARLY_TERMINATION
uniform float terminalOpacity;
#endif

#ifdef HAVS_MARKS_DONE
layout(early_fragment_tests) in;  // the stencil spares pixels that are done (done_pixels.frag)
#endif

// Distances less than this apart leave it to the order of the faces who is first.
#ifdef HAVS_ORDER_BELIEVED
const float kSamePlace = kStoredTolerance;
#else
const float kSamePlace = 0.0;
#endif

void main() {
  Rgba color;
  PixelState state;
  loadPixel(color, state);
#ifdef HAVS_EARLY_TERMINATION
  bool done = color.a >= terminalOpacity;
#else
  const bool done = false;
#endif
  KBuffer kbuffer = loadEntries();
  Fragment incoming = asStored(incomingFragment());

  bool late = !done && isLateBy(kbuffer, state, incoming, kStoredTolerance);
  if (late) countLateFragment();
#ifndef HAVS_COMPOSITE_LATE
  if (late) {
    state.inside += kindOf(incoming.payload);
    storePixel(color, state);
    return;
  }
#endif
  uvec2 layers = layersOfPixel();
  float reached = state.started > 0.5 ? kbuffer.entry[0].distance : kEmptyDistance;
  Fragment front;
  insertFragment(kbuffer, incoming, kSamePlace, front);
  Segment segment = leaveBefore(state, front, kbuffer);
  segment.visible = segment.visible && !done;
  float next = state.started > 0.5 ? kbuffer.entry[0].distance : kEmptyDistance;
  color = compositeSegment(layers, color, segmentColor(segment), segment.middle, reached, next);
  storePixel(color, state);
  storeEntries(kbuffer);
  if (done) discard;  // at the end: before the entries are read it made llvmpipe 3.5 times as slow
}
