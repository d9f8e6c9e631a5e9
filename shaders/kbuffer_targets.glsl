// How a pixel's k-buffer lies in its render targets, all RGBA32F: target 0 the colour so far, target 1 + i the entries
// 2i and 2i + 1, (payload, distance) each. The pixel's inside-count and started flag are kept in the two highest bits
// of the four colour channels, which are free as colours lie in [0, 1].
layout(location = 0) inout vec4 colorTarget;
layout(location = 1) inout vec4 entryTargets[HAVS_ENTRY_TARGETS];

Fragment asFragment(vec2 pair) {
  Fragment f;
  f.payload = pair.x;
  f.distance = pair.y;
  return f;
}

vec2 asPair(Fragment f) { return vec2(f.payload, f.distance); }

KBuffer loadEntries() {
  KBuffer kbuffer;
  for (int i = 0; i < HAVS_K; ++i) {
    vec4 pair = entryTargets[i / 2];
    kbuffer.entry[i] = asFragment(i % 2 == 0 ? pair.xy : pair.zw);
  }
  return kbuffer;
}

void storeEntries(KBuffer kbuffer) {
  for (int i = 0; i < HAVS_K; i += 2) {
    vec2 second = i + 1 < HAVS_K ? asPair(kbuffer.entry[min(i + 1, HAVS_K - 1)]) : vec2(0.0);
    entryTargets[i / 2] = vec4(asPair(kbuffer.entry[i]), second);
  }
}

// The count, offset so that it is positive, in seven bits, and the flag in the eighth.
const float kCountOffset = 64.0;

void loadPixel(out Rgba color, out PixelState state) {
  uvec4 bits = floatBitsToUint(colorTarget);
  color = uintBitsToFloat(bits & ~kFlagMask);
  uvec4 flags = bits >> 30;
  uint word = flags.x | (flags.y << 2) | (flags.z << 4) | (flags.w << 6);
  state.started = float(word & 1u);
  state.inside = state.started > 0.5 ? float(word >> 1) - kCountOffset : 0.0;
}

void storePixel(Rgba color, PixelState state) {
  uint count = uint(clamp(state.inside + kCountOffset, 0.0, 127.0));
  uint word = state.started > 0.5 ? (count << 1) | 1u : 0u;
  uvec4 flags = uvec4(word, word >> 2, word >> 4, word >> 6) << 30;
  colorTarget = uintBitsToFloat(floatBitsToUint(clamp(color, 0.0, kBelowOne)) | flags);
}
