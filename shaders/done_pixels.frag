// Marks pixels that take no more fragments, in the stencil: what is drawn after it skips them before their shader runs.
#include "core/language.glsl"
#include "payload.glsl"
#include "core/kbuffer.glsl"
#include "kbuffer_targets.glsl"
uniform float terminalOpacity;

void main() {
  Rgba color;
  PixelState state;
  loadPixel(color, state);
  if (color.a < terminalOpacity) discard;
}
