// In place of payload.glsl where fragments carry light: the scalar and kind in one float, as there; the light that falls
// on the fragment; and what the modulation by the gradient leaves of its extinction.
struct LitPayload {
  float scalarAndKind;
  float light;    // >= 0
  float density;  // 0 to 1
};
#define Payload LitPayload

const uint kFlagMask = 0xC0000000u;
const uint kEntryFlag = 0x80000000u;
const uint kExitFlag = 0x40000000u;
const float kBelowOne = 0.99999994;  // with a flag, 1.0 would be infinite; it stands for 1.0 and is read as that

Payload makeLitPayload(float scalar, float kind, float light, float density) {
  uint flag = kind > 0.5 ? kEntryFlag : kind < -0.5 ? kExitFlag : 0u;
  float room = flag == 0u ? scalar : min(scalar, kBelowOne);
  return LitPayload(uintBitsToFloat(floatBitsToUint(room) | flag), light, density);
}

Payload makePayload(float scalar, float kind) { return makeLitPayload(scalar, kind, 0.0, 1.0); }

float scalarOf(Payload payload) {
  float scalar = uintBitsToFloat(floatBitsToUint(payload.scalarAndKind) & ~kFlagMask);
  return scalar >= kBelowOne ? 1.0 : scalar;
}

float kindOf(Payload payload) {
  uint flag = floatBitsToUint(payload.scalarAndKind) & kFlagMask;
  return flag == kEntryFlag ? 1.0 : flag == kExitFlag ? -1.0 : 0.0;
}

// For the ends of segments, whose scalars stand beside them.
Payload makeLight(float light, float density) { return LitPayload(0.0, light, density); }

float lightOf(Payload payload) { return payload.light; }
float densityOf(Payload payload) { return payload.density; }

Payload selectPayload(bool condition, Payload yes, Payload no) {
  return LitPayload(mix(no.scalarAndKind, yes.scalarAndKind, condition), mix(no.light, yes.light, condition),
                    mix(no.density, yes.density, condition));
}
