#pragma once
// The arithmetic of a fragment as C++: the very files that the shaders include (shaders/core), compiled over a number
// type. Arithmetic<DoubleLane> has it in double, Arithmetic<FloatLane> with the rounding of a GPU; a SIMD batch may
// stand in as lane.
#include <bit>
#include <cmath>
#include <cstdint>

namespace havs {

struct FloatLane {
  using Real = float;
  using Mask = bool;
  using Scalar = float;
  static constexpr bool kDouble = false;
  static Real select(Mask condition, Real yes, Real no) { return condition ? yes : no; }
  static Real exp2Integral(Real n) { return std::bit_cast<float>((static_cast<std::int32_t>(n) + 127) << 23); }
  static Real roundToIntegral(Real x) { return (x + 0x1.8p23f) - 0x1.8p23f; }  // |x| < 2^22; ties to even
  static Real squareRoot(Real x) { return std::sqrt(x); }
  static Real absolute(Real x) { return std::abs(x); }
  static bool anyLane(Mask mask) { return mask; }
};

struct DoubleLane {
  using Real = double;
  using Mask = bool;
  using Scalar = double;
  static constexpr bool kDouble = true;
  static Real select(Mask condition, Real yes, Real no) { return condition ? yes : no; }
  static Real exp2Integral(Real n) { return std::bit_cast<double>((static_cast<std::int64_t>(n) + 1023) << 52); }
  static Real roundToIntegral(Real x) { return (x + 0x1.8p52) - 0x1.8p52; }  // |x| < 2^51; ties to even
  static Real squareRoot(Real x) { return std::sqrt(x); }
  static Real absolute(Real x) { return std::abs(x); }
  static bool anyLane(Mask mask) { return mask; }
};

#define FUNCTION static inline
#define INOUT(T) T&
#define OUT(T) T&
#define CONSTANT static constexpr
#define PRECISE
// The object that fetches from tables comes first: CurveFetch of transfer/packed_curve.h, for instance.
#define TABLE_FUNCTION    \
  template <class Tables> \
  static inline
#define TABLES const Tables &tables,
#define WITH_TABLES tables,
#define TABLE(fetch) tables.fetch
#define WHERE_ANY(mask) if (anyLane(mask))

/// What a fragment carries besides its distance (core/kbuffer.glsl): a scalar and its kind. All payloads have so many
/// numbers besides the kind.
template <class Lane>
struct ScalarPayload {
  using Real = typename Lane::Real;
  using Mask = typename Lane::Mask;
  static constexpr int kNumbers = 1;
  Real scalar, kind;
  Real& number(int) { return scalar; }
  static ScalarPayload make(Real scalar, Real kind) { return {scalar, kind}; }
  static Real scalarOf(const ScalarPayload& p) { return p.scalar; }
  static ScalarPayload select(Mask condition, const ScalarPayload& yes, const ScalarPayload& no) {
    return {Lane::select(condition, yes.scalar, no.scalar), Lane::select(condition, yes.kind, no.kind)};
  }
};

/// Colour and extinction, as a fraction of the largest, in place of the scalar, which reads as 0.
template <class Lane>
struct ColorPayload {
  using Real = typename Lane::Real;
  using Mask = typename Lane::Mask;
  static constexpr int kNumbers = 4;
  Real color[4], kind;
  Real& number(int i) { return color[i]; }
  static ColorPayload make(Real, Real kind) { return {{Real(0), Real(0), Real(0), Real(0)}, kind}; }
  static Real scalarOf(const ColorPayload&) { return Real(0); }
  static ColorPayload select(Mask condition, const ColorPayload& yes, const ColorPayload& no) {
    ColorPayload p;
    for (int i = 0; i < 4; ++i) p.color[i] = Lane::select(condition, yes.color[i], no.color[i]);
    p.kind = Lane::select(condition, yes.kind, no.kind);
    return p;
  }
};

/// A scalar, the light that falls on it, and what the modulation by the gradient leaves of its extinction.
template <class Lane>
struct LitPayload {
  using Real = typename Lane::Real;
  using Mask = typename Lane::Mask;
  static constexpr int kNumbers = 3;
  Real scalar, light, density, kind;
  Real& number(int i) { return i == 0 ? scalar : i == 1 ? light : density; }
  static LitPayload make(Real scalar, Real kind) { return {scalar, Real(0), Real(1), kind}; }
  static Real scalarOf(const LitPayload& p) { return p.scalar; }
  static LitPayload select(Mask condition, const LitPayload& yes, const LitPayload& no) {
    return {Lane::select(condition, yes.scalar, no.scalar), Lane::select(condition, yes.light, no.light),
            Lane::select(condition, yes.density, no.density), Lane::select(condition, yes.kind, no.kind)};
  }
};

template <class Lane, int K = 1, template <class> class PayloadOf = ScalarPayload>
struct Arithmetic {
  using Real = typename Lane::Real;
  using Mask = typename Lane::Mask;
  using Scalar = typename Lane::Scalar;
  static constexpr bool kDouble = Lane::kDouble;
  static constexpr int HAVS_K = K;
  struct Rgba {
    Real r, g, b, a;
    Rgba() = default;
    Rgba(Real r_, Real g_, Real b_, Real a_) : r(r_), g(g_), b(b_), a(a_) {}
  };
  static Real select(Mask condition, Real yes, Real no) { return Lane::select(condition, yes, no); }
  using Payload = PayloadOf<Lane>;
  static Payload makePayload(Real scalar, Real kind) { return Payload::make(scalar, kind); }
  static Real scalarOf(Payload payload) { return Payload::scalarOf(payload); }
  static Real kindOf(Payload payload) { return payload.kind; }
  static Payload selectPayload(Mask condition, Payload yes, Payload no) { return Payload::select(condition, yes, no); }
  static Real exp2Integral(Real n) { return Lane::exp2Integral(n); }
  static Real roundToIntegral(Real x) { return Lane::roundToIntegral(x); }
  static Real squareRoot(Real x) { return Lane::squareRoot(x); }
  static Real absolute(Real x) { return Lane::absolute(x); }
  static bool anyLane(Mask mask) { return Lane::anyLane(mask); }

#include "core/compositing.glsl"
#include "core/curve.glsl"
#include "core/exponential.glsl"
#include "core/kbuffer.glsl"
#include "core/lighting.glsl"
#include "core/limits.glsl"
#include "core/opaque.glsl"
// what uses the types of the above
#include "core/cell_exit.glsl"
#include "core/integration.glsl"
// what uses the types of that
#include "core/exact.glsl"
#include "core/integral_functions.glsl"
#include "core/piecewise.glsl"
#include "core/riemann.glsl"
};

#undef FUNCTION
#undef INOUT
#undef OUT
#undef CONSTANT
#undef PRECISE
#undef TABLE_FUNCTION
#undef TABLES
#undef WITH_TABLES
#undef TABLE
#undef WHERE_ANY

}  // namespace havs
