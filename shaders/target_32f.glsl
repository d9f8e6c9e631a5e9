// Render targets of 32-bit floats (RGBA32F). A word is a float's bits.
#define Texel vec4

const uint kNumberMask = 0x3FFFFFFFu;  // of a word that holds a number of [0, 1]: the two highest bits are free
const int kFreeBits = 30;              // their place
const Scalar kStoredTolerance = kLateTolerance;

uvec4 wordsIn(Texel texel) { return floatBitsToUint(texel); }
Texel texelOf(uvec4 words) { return uintBitsToFloat(words); }

uint wordOf(float number) { return floatBitsToUint(number); }
float numberIn(uint word) { return uintBitsToFloat(word); }

uint wordOfDistance(float distance) { return floatBitsToUint(distance); }
float distanceIn(uint word) { return uintBitsToFloat(word); }
float storedDistance(float distance) { return distance; }

// Two numbers of [0, 1] in 16 bits each, as packUnorm2x16 has them.
uint wordOfPair(uint pair) { return pair; }
uint pairIn(uint word) { return word; }
