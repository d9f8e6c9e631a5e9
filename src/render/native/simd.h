#pragma once
// Numbers in SIMD lanes, one type for each instruction set: what Arithmetic<Lane> (core/arithmetic.h) and the kernels
// of the native device compute with. Everything is correctly rounded and nothing is contracted, so that every
// instruction set gives the same bits. Included only by files that are compiled for their instruction set
// (CMakeLists.txt); these include nothing else whose functions other files might share.
#include <bit>
#include <cmath>
#include <cstdint>

#if defined(HAVS_SIMD_ARCH)
#include <immintrin.h>

#include <xsimd/xsimd.hpp>
#endif

namespace havs {

/// One lane: any processor.
struct ScalarLanes {
  using Real = float;
  using Mask = bool;
  using Int = std::int32_t;
  using Scalar = float;
  static constexpr bool kDouble = false;
  static constexpr std::size_t kLanes = 1;
  static Real select(Mask condition, Real yes, Real no) { return condition ? yes : no; }
  static Real exp2Integral(Real n) { return std::bit_cast<float>((static_cast<std::int32_t>(n) + 127) << 23); }
  static Real roundToIntegral(Real x) { return (x + 0x1.8p23f) - 0x1.8p23f; }
  static Real squareRoot(Real x) { return std::sqrt(x); }
  static Real absolute(Real x) { return std::abs(x); }
  static bool anyLane(Mask mask) { return mask; }

  static Real load(const float* from) { return *from; }
  static void store(float* to, Real value) { *to = value; }
  static Int toInt(Real x) { return static_cast<std::int32_t>(x); }  ///< towards zero
  static Real toReal(Int i) { return static_cast<float>(i); }
  static Int makeInt(std::int32_t i) { return i; }
  static Real gather(const float* base, Int index) { return base[index]; }
  static Int gatherInt(const std::int32_t* base, Int index) { return base[index]; }
  static unsigned bitsOf(Mask mask) { return mask ? 1u : 0u; }
  static Mask maskOf(unsigned bits) { return (bits & 1u) != 0; }
  static Real least(Real a, Real b) { return a < b ? a : b; }  ///< b where one is no number
  static Real most(Real a, Real b) { return a > b ? a : b; }   ///< the same
  static Int loadInts(const std::int32_t* from) { return *from; }
  /// Writes the values of the lanes of `mask`, whose bits are `bits`, one behind the other; up to kLanes numbers behind
  /// them may be written, too.
  static void compress(float* to, Real value, Mask, unsigned) { *to = value; }
  static void compressInts(std::int32_t* to, Int value, Mask, unsigned) { *to = value; }
};

#if defined(HAVS_SIMD_ARCH)
namespace {  // functions of one name for several instruction sets must not be merged by the linker

/// The lanes of HAVS_SIMD_ARCH, an architecture of xsimd.
struct SimdLanes {
  using Arch = HAVS_SIMD_ARCH;
  using Real = xsimd::batch<float, Arch>;
  using Mask = xsimd::batch_bool<float, Arch>;
  using Int = xsimd::batch<std::int32_t, Arch>;
  using Scalar = float;
  static constexpr bool kDouble = false;
  static constexpr std::size_t kLanes = Real::size;
  static Real select(Mask condition, Real yes, Real no) { return xsimd::select(condition, yes, no); }
  static Real exp2Integral(Real n) { return xsimd::bitwise_cast<Real>((xsimd::to_int(n) + Int(127)) << 23); }
  static Real roundToIntegral(Real x) { return (x + Real(0x1.8p23f)) - Real(0x1.8p23f); }
  static Real squareRoot(Real x) { return xsimd::sqrt(x); }
  static Real absolute(Real x) { return xsimd::abs(x); }
  static bool anyLane(Mask mask) { return xsimd::any(mask); }

  static Real load(const float* from) { return Real::load_unaligned(from); }
  static void store(float* to, Real value) { value.store_unaligned(to); }
  static Int toInt(Real x) { return xsimd::to_int(x); }
  static Real toReal(Int i) { return xsimd::to_float(i); }
  static Int makeInt(std::int32_t i) { return Int(i); }
  static Real gather(const float* base, Int index) {
#if defined(__AVX512F__)
    return _mm512_i32gather_ps(index, base, 4);
#elif defined(__AVX2__)
    return _mm256_i32gather_ps(base, index, 4);
#else
    alignas(16) std::int32_t i[4];
    index.store_aligned(i);
    return _mm_setr_ps(base[i[0]], base[i[1]], base[i[2]], base[i[3]]);
#endif
  }
  static Int gatherInt(const std::int32_t* base, Int index) {
    return xsimd::bitwise_cast<Int>(gather(reinterpret_cast<const float*>(base), index));
  }
  static unsigned bitsOf(Mask mask) {
#if defined(__AVX512F__)
    return static_cast<unsigned>(static_cast<__mmask16>(mask));
#elif defined(__AVX2__)
    return static_cast<unsigned>(_mm256_movemask_ps(mask));
#else
    return static_cast<unsigned>(_mm_movemask_ps(mask));
#endif
  }
  static Mask maskOf(unsigned bits) {
#if defined(__AVX512F__)
    return static_cast<__mmask16>(bits);
#elif defined(__AVX2__)
    const __m256i bit = _mm256_setr_epi32(1, 2, 4, 8, 16, 32, 64, 128);
    const __m256i set = _mm256_and_si256(_mm256_set1_epi32(static_cast<int>(bits)), bit);
    return _mm256_castsi256_ps(_mm256_cmpeq_epi32(set, bit));
#else
    const __m128i bit = _mm_setr_epi32(1, 2, 4, 8);
    const __m128i set = _mm_and_si128(_mm_set1_epi32(static_cast<int>(bits)), bit);
    return _mm_castsi128_ps(_mm_cmpeq_epi32(set, bit));
#endif
  }
  static Real least(Real a, Real b) { return xsimd::min(a, b); }
  static Real most(Real a, Real b) { return xsimd::max(a, b); }
  static Int loadInts(const std::int32_t* from) { return Int::load_unaligned(from); }
  static void compressInts(std::int32_t* to, Int value, Mask mask, unsigned bits) {
#if defined(__AVX512F__)
    (void)bits;
    _mm512_storeu_si512(to, _mm512_maskz_compress_epi32(mask, value));
#else
    (void)mask;
    alignas(32) std::int32_t lanes[kLanes];
    value.store_aligned(lanes);
    for (; bits != 0; bits &= bits - 1) *to++ = lanes[std::countr_zero(bits)];
#endif
  }
  static void compress(float* to, Real value, Mask mask, unsigned bits) {
#if defined(__AVX512F__)
    (void)bits;
    _mm512_storeu_ps(to, _mm512_maskz_compress_ps(mask, value));
#else
    (void)mask;
    alignas(32) float lanes[kLanes];
    value.store_aligned(lanes);
    for (; bits != 0; bits &= bits - 1) *to++ = lanes[std::countr_zero(bits)];
#endif
  }
};

}  // namespace
#else
using SimdLanes = ScalarLanes;
#endif

}  // namespace havs
