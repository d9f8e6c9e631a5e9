// The a-buffer, second pass: each fragment goes to the next place of its pixel's list. `ends` starts as the beginning of
// each list and has become its end when all are stored. The places are given out as the fragments come, so their order in a
// list is the driver's; abuffer_resolve.frag does not depend on it. To be drawn with the colour mask off.
#include "core/language.glsl"
#include "payload.glsl"
#define HAVS_K 1
#include "core/kbuffer.glsl"
#include "incoming_fragment.glsl"
#include "abuffer_lists.glsl"

layout(rg32ui, binding = 0) writeonly uniform uimageBuffer fragments;

void main() {
  Fragment incoming = incomingFragment();
  uint place = atomicAdd(ends[pixelOfTile()], 1u);
  imageStore(fragments, int(place), uvec4(floatBitsToUint(vec2(incoming.payload, incoming.distance)), 0u, 0u));
}
