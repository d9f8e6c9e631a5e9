// In place of payload.glsl where fragments carry colour and extinction instead of a scalar (lookup `pre`): extinction
// as a fraction of the largest in 32 bits, whose two highest are free for the kind; red and green in 16 bits each, blue
// in 32. Scalars are unknown here, and read as 0.
#define Payload uvec3

const uint kFlagMask = 0xC0000000u;
const uint kEntryFlag = 0x80000000u;
const uint kExitFlag = 0x40000000u;
const float kBelowOne = 0.99999994;  // the largest colour that is kept: see payload.glsl

// `color`: (r, g, b, extinction as a fraction of the largest).
Payload makeColorPayload(vec4 color, float kind) {
  uint flag = kind > 0.5 ? kEntryFlag : kind < -0.5 ? kExitFlag : 0u;
  vec4 inRange = clamp(color, 0.0, 1.0);
  return Payload(floatBitsToUint(min(inRange.a, kBelowOne)) | flag, packUnorm2x16(inRange.rg), floatBitsToUint(inRange.b));
}

vec4 colorOf(Payload payload) {
  return vec4(unpackUnorm2x16(payload.y), uintBitsToFloat(payload.z), uintBitsToFloat(payload.x & ~kFlagMask));
}

Payload makePayload(float scalar, float kind) { return makeColorPayload(vec4(0.0), kind); }

float scalarOf(Payload payload) { return 0.0; }

float kindOf(Payload payload) {
  uint flag = payload.x & kFlagMask;
  return flag == kEntryFlag ? 1.0 : flag == kExitFlag ? -1.0 : 0.0;
}

Payload selectPayload(bool condition, Payload yes, Payload no) { return condition ? yes : no; }
