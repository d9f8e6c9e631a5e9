// After the last face: the entries left in the pixel's k-buffer leave in order; the colour is written plain, without
// flags.
#include "core/language.glsl"
#include "payload.glsl"
#include "core/kbuffer.glsl"
#include "core/compositing.glsl"
#include "kbuffer_targets.glsl"
#include "segment_color.glsl"
#include "layers.glsl"

#ifdef HAVS_EARLY_TERMINATION
uniform float terminalOpacity;
#endif

void main() {
  Rgba color;
  PixelState state;
  loadPixel(color, state);
  KBuffer kbuffer = loadEntries();
  uvec2 layers = layersOfPixel();
  float reached = state.started > 0.5 ? kbuffer.entry[0].distance : kEmptyDistance;
#if HAVS_K > 1
  // A loop by a condition ends at once where all pixels of a block are empty.
  bool any = !isEmpty(kbuffer.entry[HAVS_K - 1]);
  int left = HAVS_K - 1;
  do {
    Fragment front = takeNearest(kbuffer);
    Segment segment = leaveBefore(state, front, kbuffer);
    float end = kbuffer.entry[0].distance;
#ifdef HAVS_EARLY_TERMINATION
    bool done = color.a >= terminalOpacity;
    segment.visible = segment.visible && !done;
    if (done) end = reached;
#endif
    color = compositeSegment(layers, color, segmentColor(segment), segment.middle, reached, end);
    reached = end;
    --left;
  } while (any && left > 0);
#endif
#ifdef HAVS_LAYERS
  bool ended = false;
#ifdef HAVS_EARLY_TERMINATION
  ended = color.a >= terminalOpacity;
#endif
  if (!ended) color = compositeRest(layers, color, reached);
#endif
  storeColor(color);
}
