// Render targets of half floats. A word is a half's bits, kept in 16-bit integers (RGBA16UI), as no driver promises to
// keep every bit pattern of a half. Halves have 11 digits: distances near 1 are 5e-4 apart, opacities too.
#define Texel uvec4

const uint kNumberMask = 0x3FFFu;  // of a word that holds a number of [0, 1]: the two highest bits are free
const int kFreeBits = 14;          // their place
// Distances 1e-6 apart may be rounded to neighbours, which are 2^-10 apart from 1 to 2.
const Scalar kStoredTolerance = 1.0e-3;
const uint kEmptyWord = 0xFBFFu;  // -65504, the lowest half
const float kFarthest = 6.0e4;

uvec4 wordsIn(Texel texel) { return texel; }
Texel texelOf(uvec4 words) { return words; }

// To the nearest half, ties to even; packHalf2x16 may cut digits off. Below 2^-14 its step is 6e-8, and it may.
float roundedToHalf(float number) {
  uint bits = floatBitsToUint(number);
  bits += 0x0FFFu + ((bits >> 13) & 1u);
  return uintBitsToFloat(bits & ~0x1FFFu);
}

uint wordOf(float number) { return packHalf2x16(vec2(roundedToHalf(number), 0.0)); }
float numberIn(uint word) { return unpackHalf2x16(word).x; }

float storedDistance(float distance) { return roundedToHalf(clamp(distance, -kFarthest, kFarthest)); }
uint wordOfDistance(float distance) { return distance < kEmptyLimit ? kEmptyWord : wordOf(storedDistance(distance)); }
float distanceIn(uint word) { return word == kEmptyWord ? kEmptyDistance : numberIn(word); }

// Two numbers of [0, 1] in 8 bits each; `pair` as packUnorm2x16 has them.
uint wordOfPair(uint pair) { return packUnorm4x8(vec4(unpackUnorm2x16(pair), 0.0, 0.0)); }
uint pairIn(uint word) { return packUnorm2x16(unpackUnorm4x8(word).xy); }
