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
  for (int i = 0; i + 1 < HAVS_K; ++i) {
    Segment segment = leave(state, kbuffer.entry[i], kbuffer.entry[i + 1]);
#ifdef HAVS_EARLY_TERMINATION
    segment.visible = segment.visible && color.a < terminalOpacity;
#endif
    color = compositeUnder(color, segmentColor(segment));
  }
  storeColor(color);
}
