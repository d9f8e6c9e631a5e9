#pragma once
// Colours in lanes from and to four floats each in memory, by whole 128-bit loads and stores and their transpose: that
// takes a third of the time of four gathers. For kernels only, as simd.h.
#include "render/native/simd.h"

namespace havs {
namespace {

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

inline __m512 loadParts(const float* base, const std::int32_t* offsets) {
  __m512 v = _mm512_castps128_ps512(_mm_loadu_ps(base + offsets[0]));
  v = _mm512_insertf32x4(v, _mm_loadu_ps(base + offsets[4]), 1);
  v = _mm512_insertf32x4(v, _mm_loadu_ps(base + offsets[8]), 2);
  return _mm512_insertf32x4(v, _mm_loadu_ps(base + offsets[12]), 3);
}

/// Of lanes 0 4 8 12, 1 5 9 13, 2 6 10 14, 3 7 11 15 those in a row.
inline void storeParts(float* to, __m512 a, __m512 b, __m512 c, __m512 d) {
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

inline __m256 loadParts(const float* base, const std::int32_t* offsets) {
  return _mm256_insertf128_ps(_mm256_castps128_ps256(_mm_loadu_ps(base + offsets[0])), _mm_loadu_ps(base + offsets[4]),
                              1);
}

/// Of lanes 0 4, 1 5, 2 6, 3 7 those in a row.
inline void storeParts(float* to, __m256 a, __m256 b, __m256 c, __m256 d) {
  _mm256_storeu_ps(to, _mm256_permute2f128_ps(a, b, 0x20));
  _mm256_storeu_ps(to + 8, _mm256_permute2f128_ps(c, d, 0x20));
  _mm256_storeu_ps(to + 16, _mm256_permute2f128_ps(a, b, 0x31));
  _mm256_storeu_ps(to + 24, _mm256_permute2f128_ps(c, d, 0x31));
}

#elif defined(HAVS_SIMD_ARCH)

inline void transpose(__m128& a, __m128& b, __m128& c, __m128& d) { _MM_TRANSPOSE4_PS(a, b, c, d); }

inline __m128 loadParts(const float* base, const std::int32_t* offsets) { return _mm_loadu_ps(base + offsets[0]); }

inline void storeParts(float* to, __m128 a, __m128 b, __m128 c, __m128 d) {
  _mm_storeu_ps(to, a);
  _mm_storeu_ps(to + 4, b);
  _mm_storeu_ps(to + 8, c);
  _mm_storeu_ps(to + 12, d);
}

#endif

/// SimdLanes with what lookups need.
struct RgbaLanes : SimdLanes {
#if defined(__AVX512F__)
  static constexpr bool kChooses = true;
  /// Of a table of at most 64 numbers in memory, of which `entries` are used: a tenth of the time of a gather.
  static Real choose(const float* table, int entries, Int i) {
    const __m512i at = i;
    const __m512 low = _mm512_permutex2var_ps(_mm512_load_ps(table), at, _mm512_load_ps(table + 16));
    if (entries <= 32) return low;
    const __m512 high = _mm512_permutex2var_ps(_mm512_load_ps(table + 32), at, _mm512_load_ps(table + 48));
    return _mm512_mask_blend_ps(_mm512_test_epi32_mask(at, _mm512_set1_epi32(32)), low, high);
  }
#else
  static constexpr bool kChooses = false;
  static Real choose(const float* table, int, Int i) { return gather(table, i); }
#endif
#if defined(HAVS_SIMD_ARCH)
  /// The four floats at base + offsets[lane].
  static void loadRgba(const float* base, const std::int32_t* offsets, Real (&color)[4]) {
    auto a = loadParts(base, offsets), b = loadParts(base, offsets + 1);
    auto c = loadParts(base, offsets + 2), d = loadParts(base, offsets + 3);
    transpose(a, b, c, d);
    color[0] = a;
    color[1] = b;
    color[2] = c;
    color[3] = d;
  }
  static void storeRgba(float* to, const Real (&color)[4]) {
    auto a = color[0].data, b = color[1].data, c = color[2].data, d = color[3].data;
    transpose(a, b, c, d);
    storeParts(to, a, b, c, d);
  }
  static void storeInts(std::int32_t* to, Int i) { i.store_unaligned(to); }
#else
  static void loadRgba(const float* base, const std::int32_t* offsets, Real (&color)[4]) {
    for (int c = 0; c < 4; ++c) color[c] = base[*offsets + c];
  }
  static void storeRgba(float* to, const Real (&color)[4]) {
    for (int c = 0; c < 4; ++c) to[c] = color[c];
  }
  static void storeInts(std::int32_t* to, Int i) { *to = i; }
#endif
};

}  // namespace
}  // namespace havs
