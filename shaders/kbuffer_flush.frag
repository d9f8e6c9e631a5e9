// After the last face: the entries left in the pixel's k-buffer leave in order; the colour is written plain, without
// flags.
#include "core/language.glsl"
#include "payload.glsl"
#include "core/kbuffer.glsl"
#include "core/compositing.glsl"
#include "kbuffer_targets.glsl"
#include "segment_color.glsl"

#ifdef HAVS_EARLY_TERMINATION
uniform float terminalOpacity;
#endif

void main() {
  Rgba color;
  PixelState state;
  loadPixel(color, state);
  KBuffer kbuffer = loadEntries();
#if HAVS_K > 1
  // A loop by a condition ends at once where all pixels of a block are empty.
  bool any = !isEmpty(kbuffer.entry[HAVS_K - 1]);
  int left = HAVS_K - 1;
  do {
    Segment segment = leave(state, kbuffer.entry[0], kbuffer.entry[1]);
#ifdef HAVS_EARLY_TERMINATION
    segment.visible = segment.visible && color.a < terminalOpacity;
#endif
    color = compositeUnder(color, segmentColor(segment));
    for (int i = 0; i + 1 < HAVS_K; ++i) kbuffer.entry[i] = kbuffer.entry[i + 1];
    --left;
  } while (any && left > 0);
#endif
  storeColor(color);
}
