// The a-buffer (Carpenter 1984), last pass: the list of each pixel is sorted, and its fragments leave one after another as
// from a k-buffer: the same segments, inside-count, lookup and compositing.
#include "core/language.glsl"
#include "payload.glsl"
#define HAVS_K 1
#include "core/kbuffer.glsl"
#include "core/compositing.glsl"
#include "segment_color.glsl"
#include "layers.glsl"
#include "abuffer_lists.glsl"
#include "abuffer_sort.glsl"

layout(location = 0) out vec4 colorTarget;

#ifdef HAVS_EARLY_TERMINATION
uniform float terminalOpacity;
#endif

// What a pixel shows whose list the loops did not come to the end of: llvmpipe ends all loops of a shader after 65,535
// turns together, without a word.
const float kCutShort = -1.0;

void main() {
  int pixel = pixelOfTile();
  int first = pixel == 0 ? 0 : int(ends[pixel - 1]);
  int count = int(ends[pixel]) - first;
  Rgba color = Rgba(0.0);
  uvec2 layers = layersOfPixel();
  float reached = kEmptyDistance;
  bool whole = true;
  if (count > 1) {
    PixelState state = PixelState(0.0, 0.0);
    Merge list = sortList(first, count);
    Fragment front = fragmentOf(takeNext(list)), back = fragmentOf(takeNext(list));
    orderBoundaries(front, back, 0.0);
    float turns = 1.0;  // counted apart: of `i` the compiler knows what it is behind the loop
    for (int i = 1; i < count; ++i) {
      turns += 1.0;
      Fragment beyond = fragmentOf(takeNext(list));  // of no kind behind the last
      orderBoundaries(back, beyond, state.inside + kindOf(front.payload));
      Segment segment = leave(state, front, back);
      color = compositeSegment(layers, color, segmentColor(segment), segment.middle, reached, back.distance);
      reached = back.distance;
      front = back;
      back = beyond;
#ifdef HAVS_EARLY_TERMINATION
      if (color.a >= terminalOpacity) {
        turns = float(count);
        break;
      }
#endif
    }
    whole = turns >= float(count);
  }
#ifdef HAVS_LAYERS
  bool ended = false;
#ifdef HAVS_EARLY_TERMINATION
  ended = color.a >= terminalOpacity;
#endif
  if (!ended) color = compositeRest(layers, color, reached);
#endif
  colorTarget = whole ? color : vec4(kCutShort);
}
