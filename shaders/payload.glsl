// A fragment's scalar and kind in one float. The scalar lies in [0, 1], so the two highest bits of its float are free
// for the kind: no precision is spent, and the k-buffer moves one number less.
#define Payload float

const uint kFlagMask = 0xC0000000u;
const uint kEntryFlag = 0x80000000u;
const uint kExitFlag = 0x40000000u;
const float kBelowOne = 0.99999994;  // with a flag, 1.0 would be infinite; it stands for 1.0 and is read as that

Payload makePayload(float scalar, float kind) {
  uint flag = kind > 0.5 ? kEntryFlag : kind < -0.5 ? kExitFlag : 0u;
  float room = flag == 0u ? scalar : min(scalar, kBelowOne);
  return uintBitsToFloat(floatBitsToUint(room) | flag);
}

float scalarOf(Payload payload) {
  float scalar = uintBitsToFloat(floatBitsToUint(payload) & ~kFlagMask);
  return scalar >= kBelowOne ? 1.0 : scalar;
}

float kindOf(Payload payload) {
  uint flag = floatBitsToUint(payload) & kFlagMask;
  return flag == kEntryFlag ? 1.0 : flag == kExitFlag ? -1.0 : 0.0;
}

Payload selectPayload(bool condition, Payload yes, Payload no) { return mix(no, yes, condition); }
