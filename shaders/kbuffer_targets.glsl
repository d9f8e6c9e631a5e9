// How a pixel's k-buffer lies in its render targets, all RGBA32F: target 0 the colour so far, target 1 + i the entries 2i and 2i + 1,
// (scalar, distance) each. Scalars and colours lie in [0, 1], so the two highest bits of their floats are free: an entry keeps its kind in those
// of its scalar, the pixel keeps its inside-count and the started flag in those of its four colour channels. No target and no precision is spent.
layout(location = 0) inout vec4 colorTarget;
layout(location = 1) inout vec4 entryTargets[HAVS_ENTRY_TARGETS];

const uint kFlagMask = 0xC0000000u;
const uint kEntryFlag = 0x80000000u;
const uint kExitFlag = 0x40000000u;
const float kBelowOne = 0.99999994;  // with a flag, 1.0 would be infinite

vec2 packFragment(Fragment f) {
  uint bits = floatBitsToUint(min(f.scalar, kBelowOne));
  uint flag = f.kind > 0.5 ? kEntryFlag : f.kind < -0.5 ? kExitFlag : 0u;
  return vec2(flag == 0u ? f.scalar : uintBitsToFloat(bits | flag), f.distance);
}

Fragment unpackFragment(vec2 packed) {
  uint bits = floatBitsToUint(packed.x);
  Fragment f;
  uint flag = bits & kFlagMask;
  f.scalar = uintBitsToFloat(bits & ~kFlagMask);
  f.distance = packed.y;
  f.kind = flag == kEntryFlag ? 1.0 : flag == kExitFlag ? -1.0 : 0.0;
  return f;
}

KBuffer loadEntries() {
  KBuffer buffer;
  for (int i = 0; i < HAVS_K; ++i) {
    vec4 pair = entryTargets[i / 2];
    buffer.entry[i] = unpackFragment(i % 2 == 0 ? pair.xy : pair.zw);
  }
  return buffer;
}

void storeEntries(KBuffer buffer) {
  for (int i = 0; i < HAVS_K; i += 2) {
    vec2 second = i + 1 < HAVS_K ? packFragment(buffer.entry[min(i + 1, HAVS_K - 1)]) : vec2(0.0);
    entryTargets[i / 2] = vec4(packFragment(buffer.entry[i]), second);
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
