// The order certificate: how many late fragments each pixel has had. The count is touched where a fragment is late and
// nowhere else. With HAVS_LATE_FLAG it is only noted that there was one, somewhere; a program without either knows
// nothing of it.
#ifdef HAVS_CERTIFICATE
layout(std430, binding = 2) buffer LateFragments { uint lateFragments[]; };  // of each pixel, rows from the bottom up
uniform int pixelsPerRow;

void countLateFragment() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  atomicAdd(lateFragments[pixel.y * pixelsPerRow + pixel.x], 1u);
}
#elif defined(HAVS_LATE_FLAG)
layout(std430, binding = 2) buffer LateFlag { uint anyLate; };

void countLateFragment() { anyLate = 1u; }
#else
void countLateFragment() {}
#endif
