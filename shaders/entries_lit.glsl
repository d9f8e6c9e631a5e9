// Entries that carry light: one to a target, (payload, distance, light, density).

Fragment fragmentIn(uvec4 words) {
  uint flags = words.x >> kFreeBits << 30;
  Fragment f;
  f.payload = LitPayload(uintBitsToFloat(floatBitsToUint(numberIn(words.x & kNumberMask)) | flags), numberIn(words.z),
                         numberIn(words.w));
  f.distance = distanceIn(words.y);
  return f;
}

uvec4 wordsOf(Fragment f) {
  uint flags = floatBitsToUint(f.payload.scalarAndKind) >> 30 << kFreeBits;
  return uvec4(wordOf(scalarOf(f.payload)) | flags, wordOfDistance(f.distance), wordOf(f.payload.light),
               wordOf(f.payload.density));
}

KBuffer loadEntries() {
  KBuffer kbuffer;
  for (int i = 0; i < HAVS_K; ++i) kbuffer.entry[i] = fragmentIn(wordsIn(entryTargets[i]));
  return kbuffer;
}

void storeEntries(KBuffer kbuffer) {
  for (int i = 0; i < HAVS_K; ++i) entryTargets[i] = texelOf(wordsOf(kbuffer.entry[i]));
}
