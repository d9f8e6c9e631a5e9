#pragma once
// Colours in lanes (structure of arrays) from and to four floats each in memory: whole 128-bit loads and stores and
// their transpose, which take a third of the time of four gathers. Included after simd.h, by kernels only.
#include "render/native/simd.h"

namespace havs {
namespace {

struct RgbaLanes {
  using Real = SimdLanes::Real;
  Real r, g, b, a;
  RgbaLanes() = default;
  RgbaLanes(Real r_, Real g_, Real b_, Real a_) : r(r_), g(g_), b(b_), a(a_) {}
};

#if defined(__AVX512F__)

/// Of each 4 x 4 numbers in the 128-bit parts of a, b, c, d the transpose.
inline void transpose(__m512& a, __m512& b, __m512& c, __m512& d) {
  const __m512 ab0 = _mm512_unpacklo_ps(a, b), ab1 = _mm512_unpackhi_ps(a, b);
  const __m512 cd0 = _mm512_unpacklo_ps(c, d), cd1 = _mm512_unpackhi_ps(c, d);
  a = _mm512_shuffle_ps(ab0, cd0, 0x44);
  b = _mm512_shuffle_ps(ab0, cd0, 0xEE);
  c = _mm512_shuffle_ps(ab1, cd1, 0x44);
  d = _mm512_shuffle_ps(ab1, cd1, 0xEE);
}

inline RgbaLanes loadRgba(const float* base, const std::int32_t* offsets) {
  const auto parts = [&](int first) {
    __m512 v = _mm512_castps128_ps512(_mm_loadu_ps(base + offsets[first]));
    v = _mm512_insertf32x4(v, _mm_loadu_ps(base + offsets[first + 4]), 1);
    v = _mm512_insertf32x4(v, _mm_loadu_ps(base + offsets[first + 8]), 2);
    return _mm512_insertf32x4(v, _mm_loadu_ps(base + offsets[first + 12]), 3);
  };
  __m512 a = parts(0), b = parts(1), c = parts(2), d = parts(3);
  transpose(a, b, c, d);
  return {a, b, c, d};
}

inline void storeRgba(float* to, const RgbaLanes& color) {
  __m512 a = color.r, b = color.g, c = color.b, d = color.a;
  transpose(a, b, c, d);  // segments 0 4 8 12, 1 5 9 13, ...
  const __m512 ab0 = _mm512_shuffle_f32x4(a, b, 0x44), ab1 = _mm512_shuffle_f32x4(a, b, 0xEE);
  const __m512 cd0 = _mm512_shuffle_f32x4(c, d, 0x44), cd1 = _mm512_shuffle_f32x4(c, d, 0xEE);
  _mm512_storeu_ps(to, _mm512_shuffle_f32x4(ab0, cd0, 0x88));
  _mm512_storeu_ps(to + 16, _mm512_shuffle_f32x4(ab0, cd0, 0xDD));
  _mm512_storeu_ps(to + 32, _mm512_shuffle_f32x4(ab1, cd1, 0x88));
  _mm512_storeu_ps(to + 48, _mm512_shuffle_f32x4(ab1, cd1, 0xDD));
}

#elif defined(__AVX2__)

inline void transpose(__m256& a, __m256& b, __m256& c, __m256& d) {
  const __m256 ab0 = _mm256_unpacklo_ps(a, b), ab1 = _mm256_unpackhi_ps(a, b);
  const __m256 cd0 = _mm256_unpacklo_ps(c, d), cd1 = _mm256_unpackhi_ps(c, d);
  a = _mm256_shuffle_ps(ab0, cd0, 0x44);
  b = _mm256_shuffle_ps(ab0, cd0, 0xEE);
  c = _mm256_shuffle_ps(ab1, cd1, 0x44);
  d = _mm256_shuffle_ps(ab1, cd1, 0xEE);
}

inline RgbaLanes loadRgba(const float* base, const std::int32_t* offsets) {
  const auto parts = [&](int first) {
    return _mm256_insertf128_ps(_mm256_castps128_ps256(_mm_loadu_ps(base + offsets[first])),
                                _mm_loadu_ps(base + offsets[first + 4]), 1);
  };
  __m256 a = parts(0), b = parts(1), c = parts(2), d = parts(3);
  transpose(a, b, c, d);
  return {a, b, c, d};
}

inline void storeRgba(float* to, const RgbaLanes& color) {
  __m256 a = color.r, b = color.g, c = color.b, d = color.a;
  transpose(a, b, c, d);  // segments 0 4, 1 5, 2 6, 3 7
  _mm256_storeu_ps(to, _mm256_permute2f128_ps(a, b, 0x20));
  _mm256_storeu_ps(to + 8, _mm256_permute2f128_ps(c, d, 0x20));
  _mm256_storeu_ps(to + 16, _mm256_permute2f128_ps(a, b, 0x31));
  _mm256_storeu_ps(to + 24, _mm256_permute2f128_ps(c, d, 0x31));
}

#elif defined(HAVS_SIMD_ARCH)

inline RgbaLanes loadRgba(const float* base, const std::int32_t* offsets) {
  __m128 a = _mm_loadu_ps(base + offsets[0]), b = _mm_loadu_ps(base + offsets[1]);
  __m128 c = _mm_loadu_ps(base + offsets[2]), d = _mm_loadu_ps(base + offsets[3]);
  _MM_TRANSPOSE4_PS(a, b, c, d);
  return {a, b, c, d};
}

inline void storeRgba(float* to, const RgbaLanes& color) {
  __m128 a = color.r, b = color.g, c = color.b, d = color.a;
  _MM_TRANSPOSE4_PS(a, b, c, d);
  _mm_storeu_ps(to, a);
  _mm_storeu_ps(to + 4, b);
  _mm_storeu_ps(to + 8, c);
  _mm_storeu_ps(to + 12, d);
}

#else

inline RgbaLanes loadRgba(const float* base, const std::int32_t* offsets) {
  const float* const from = base + *offsets;
  return {from[0], from[1], from[2], from[3]};
}

inline void storeRgba(float* to, const RgbaLanes& color) {
  to[0] = color.r;
  to[1] = color.g;
  to[2] = color.b;
  to[3] = color.a;
}

#endif

/// The integers of the lanes in memory.
struct Indices {
  alignas(64) std::int32_t at[SimdLanes::kLanes];
  explicit Indices(SimdLanes::Int i) {
#if defined(HAVS_SIMD_ARCH)
    i.store_aligned(at);
#else
    at[0] = i;
#endif
  }
};

}  // namespace
}  // namespace havs
