#pragma once
// Two batches of lanes side by side, operation by operation: while one waits for a result, the processor has the other
// to do. For kernels only, as simd.h.
#include "render/native/rgba_lanes.h"

namespace havs {
namespace {

/// Lanes with twice as many of them as Base has.
template <class Base>
struct LanePairs {
  struct Mask {
    typename Base::Mask a, b;
    Mask() = default;
    Mask(typename Base::Mask a_, typename Base::Mask b_) : a(a_), b(b_) {}
    friend Mask operator&&(Mask x, Mask y) { return {x.a && y.a, x.b && y.b}; }
    friend Mask operator||(Mask x, Mask y) { return {x.a || y.a, x.b || y.b}; }
    friend Mask operator!(Mask x) { return {!x.a, !x.b}; }
  };
  struct Real {
    typename Base::Real a, b;
    Real() = default;
    Real(float both) : a(both), b(both) {}
    Real(typename Base::Real a_, typename Base::Real b_) : a(a_), b(b_) {}
    friend Real operator+(Real x, Real y) { return {x.a + y.a, x.b + y.b}; }
    friend Real operator-(Real x, Real y) { return {x.a - y.a, x.b - y.b}; }
    friend Real operator*(Real x, Real y) { return {x.a * y.a, x.b * y.b}; }
    friend Real operator/(Real x, Real y) { return {x.a / y.a, x.b / y.b}; }
    friend Mask operator<(Real x, Real y) { return {x.a < y.a, x.b < y.b}; }
    friend Mask operator>(Real x, Real y) { return {x.a > y.a, x.b > y.b}; }
    friend Mask operator<=(Real x, Real y) { return {x.a <= y.a, x.b <= y.b}; }
    friend Mask operator>=(Real x, Real y) { return {x.a >= y.a, x.b >= y.b}; }
  };
  struct Int {
    typename Base::Int a, b;
    Int() = default;
    Int(std::int32_t both) : a(both), b(both) {}
    Int(typename Base::Int a_, typename Base::Int b_) : a(a_), b(b_) {}
    friend Int operator+(Int x, Int y) { return {x.a + y.a, x.b + y.b}; }
    friend Int operator*(Int x, Int y) { return {x.a * y.a, x.b * y.b}; }
  };
  static constexpr std::size_t kLanes = 2 * Base::kLanes;

  static Real select(Mask m, Real x, Real y) { return {Base::select(m.a, x.a, y.a), Base::select(m.b, x.b, y.b)}; }
  static Real exp2Integral(Real x) { return {Base::exp2Integral(x.a), Base::exp2Integral(x.b)}; }
  static Real roundToIntegral(Real x) { return {Base::roundToIntegral(x.a), Base::roundToIntegral(x.b)}; }
  static Real squareRoot(Real x) { return {Base::squareRoot(x.a), Base::squareRoot(x.b)}; }
  static Real absolute(Real x) { return {Base::absolute(x.a), Base::absolute(x.b)}; }
  static bool anyLane(Mask m) { return Base::anyLane(m.a || m.b); }

  static Int toInt(Real x) { return {Base::toInt(x.a), Base::toInt(x.b)}; }
  static Real toReal(Int i) { return {Base::toReal(i.a), Base::toReal(i.b)}; }
  static Real load(const float* from) { return {Base::load(from), Base::load(from + Base::kLanes)}; }
  static void store(float* to, Real x) {
    Base::store(to, x.a);
    Base::store(to + Base::kLanes, x.b);
  }
  static void storeInts(std::int32_t* to, Int i) {
    Base::storeInts(to, i.a);
    Base::storeInts(to + Base::kLanes, i.b);
  }
  static constexpr bool kChooses = Base::kChooses;
  static Real choose(const float* table, int entries, Int i) {
    return {Base::choose(table, entries, i.a), Base::choose(table, entries, i.b)};
  }
  static Real gather(const float* base, Int i) { return {Base::gather(base, i.a), Base::gather(base, i.b)}; }
  static void loadRgba(const float* base, const std::int32_t* offsets, Real (&color)[4]) {
    typename Base::Real a[4], b[4];
    Base::loadRgba(base, offsets, a);
    Base::loadRgba(base, offsets + Base::kLanes, b);
    for (int c = 0; c < 4; ++c) color[c] = {a[c], b[c]};
  }
  static void storeRgba(float* to, const Real (&color)[4]) {
    Base::storeRgba(to, {color[0].a, color[1].a, color[2].a, color[3].a});
    Base::storeRgba(to + 4 * Base::kLanes, {color[0].b, color[1].b, color[2].b, color[3].b});
  }
};

}  // namespace
}  // namespace havs
