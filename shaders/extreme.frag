// The scalar where a ray meets a face; blending keeps the greatest or the least.
#include "core/language.glsl"
#include "payload.glsl"
#define HAVS_K 1
#include "core/kbuffer.glsl"
#include "incoming_fragment.glsl"

layout(location = 0) out vec4 extreme;

void main() {
  Fragment fragment = incomingFragment();
#ifdef HAVS_CELL_DATA
  if (kindOf(fragment.payload) < -0.5) discard;  // no cell lies behind
#endif
  extreme = vec4(scalarOf(fragment.payload));
}
