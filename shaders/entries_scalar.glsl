// Entries that carry a scalar: two to a target, (payload, distance) each.

Fragment fragmentIn(uvec2 words) {
  uint flags = words.x >> kFreeBits << 30;
  Fragment f;
  f.payload = uintBitsToFloat(floatBitsToUint(numberIn(words.x & kNumberMask)) | flags);
  f.distance = distanceIn(words.y);
  return f;
}

uvec2 wordsOf(Fragment f) {
  uint flags = floatBitsToUint(f.payload) >> 30 << kFreeBits;
  return uvec2(wordOf(scalarOf(f.payload)) | flags, wordOfDistance(f.distance));
}

KBuffer loadEntries() {
  KBuffer kbuffer;
  for (int i = 0; i < HAVS_K; ++i) {
    uvec4 words = wordsIn(entryTargets[i / 2]);
    kbuffer.entry[i] = fragmentIn(i % 2 == 0 ? words.xy : words.zw);
  }
  return kbuffer;
}

void storeEntries(KBuffer kbuffer) {
  for (int i = 0; i < HAVS_K; i += 2) {
    uvec2 second = i + 1 < HAVS_K ? wordsOf(kbuffer.entry[min(i + 1, HAVS_K - 1)]) : uvec2(0u);
    entryTargets[i / 2] = texelOf(uvec4(wordsOf(kbuffer.entry[i]), second));
  }
}
