// Entries that carry colour and extinction: one to a target, (extinction and kind, red and green, blue, distance).

Fragment fragmentIn(uvec4 words) {
  uint flags = words.x >> kFreeBits << 30;
  Fragment f;
  f.payload = Payload(floatBitsToUint(numberIn(words.x & kNumberMask)) | flags, pairIn(words.y),
                      floatBitsToUint(numberIn(words.z)));
  f.distance = distanceIn(words.w);
  return f;
}

uvec4 wordsOf(Fragment f) {
  uint flags = f.payload.x >> 30 << kFreeBits;
  return uvec4(wordOf(uintBitsToFloat(f.payload.x & ~kFlagMask)) | flags, wordOfPair(f.payload.y),
               wordOf(uintBitsToFloat(f.payload.z)), wordOfDistance(f.distance));
}

KBuffer loadEntries() {
  KBuffer kbuffer;
  for (int i = 0; i < HAVS_K; ++i) kbuffer.entry[i] = fragmentIn(wordsIn(entryTargets[i]));
  return kbuffer;
}

void storeEntries(KBuffer kbuffer) {
  for (int i = 0; i < HAVS_K; ++i) entryTargets[i] = texelOf(wordsOf(kbuffer.entry[i]));
}
