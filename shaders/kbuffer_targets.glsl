// How a pixel's k-buffer lies in its render targets: target 0 the colour so far, the others the entries, as the payload
// has it (entries.glsl). The plan chooses the numbers (target_format.glsl: target_32f.glsl or target_16f.glsl). The
// pixel's inside-count and started flag are kept in the two highest bits of the four colour channels, which are free as
// colours lie in [0, 1].
#include "target_format.glsl"
layout(location = 0) inout Texel colorTarget;
layout(location = 1) inout Texel entryTargets[HAVS_ENTRY_TARGETS];

#include "entries.glsl"  // loadEntries(), storeEntries()

// The fragment as an entry would keep it: all distances that are compared have been rounded alike.
Fragment asStored(Fragment f) {
  f.distance = storedDistance(f.distance);
  return f;
}

Rgba numbersIn(uvec4 words) { return Rgba(numberIn(words.x), numberIn(words.y), numberIn(words.z), numberIn(words.w)); }
uvec4 wordsOf(Rgba numbers) { return uvec4(wordOf(numbers.r), wordOf(numbers.g), wordOf(numbers.b), wordOf(numbers.a)); }

// The count, offset so that it is positive, in seven bits, and the flag in the eighth.
const float kCountOffset = 64.0;

void loadPixel(out Rgba color, out PixelState state) {
  uvec4 words = wordsIn(colorTarget);
  color = numbersIn(words & kNumberMask);
  uvec4 flags = words >> kFreeBits;
  uint word = flags.x | (flags.y << 2) | (flags.z << 4) | (flags.w << 6);
  state.started = float(word & 1u);
  state.inside = state.started > 0.5 ? float(word >> 1) - kCountOffset : 0.0;
}

void storePixel(Rgba color, PixelState state) {
  uint count = uint(clamp(state.inside + kCountOffset, 0.0, 127.0));
  uint word = state.started > 0.5 ? (count << 1) | 1u : 0u;
  uvec4 flags = (uvec4(word, word >> 2, word >> 4, word >> 6) & 3u) << kFreeBits;
  colorTarget = texelOf(wordsOf(clamp(color, 0.0, kBelowOne)) | flags);
}

// The colour plain, without flags: the picture.
void storeColor(Rgba color) { colorTarget = texelOf(wordsOf(clamp(color, 0.0, 1.0))); }
