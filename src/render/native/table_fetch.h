#pragma once
// What the lookups in shaders/ read, in lanes: numbers and texels by their number, tables filtered linearly.
#include "render/native/lane_pairs.h"
#include "render/native/lookup_data.h"

namespace havs {
namespace {

/// The lanes of the lookups.
using Lanes = LanePairs<RgbaLanes>;

using Texels = LookupData::Uniform;
struct Table2d : LookupData::Uniform {};
struct Table3d : LookupData::Uniform {};

struct LaneColor {
  using Real = Lanes::Real;
  Real r, g, b, a;
  LaneColor() = default;
  LaneColor(Real r_, Real g_, Real b_, Real a_) : r(r_), g(g_), b(b_), a(a_) {}
};

inline LaneColor loadColor(const float* base, const std::int32_t* offsets) {
  Lanes::Real color[4];
  Lanes::loadRgba(base, offsets, color);
  return {color[0], color[1], color[2], color[3]};
}

inline void storeColor(float* to, const LaneColor& color) {
  Lanes::storeRgba(to, {color.r, color.g, color.b, color.a});
}

/// The integers of the lanes in memory.
struct Indices {
  alignas(64) std::int32_t at[Lanes::kLanes];
  explicit Indices(Lanes::Int i) { Lanes::storeInts(at, i); }
};

inline LaneColor rgbaAt(const Texels& texels, Lanes::Int i) {
  if constexpr (Lanes::kChooses) {
    if (texels.channels != nullptr) {
      const auto channel = [&](int c) { return Lanes::choose(texels.channels + c * kSmallTable, texels.size[0], i); };
      return {channel(0), channel(1), channel(2), channel(3)};
    }
  }
  return loadColor(texels.values, Indices(Lanes::Int(4) * i).at);
}
inline Lanes::Real numberAt(const Texels& texels, Lanes::Int i) { return Lanes::gather(texels.values, i); }
inline float scalarAt(const Texels& texels, int i) { return texels.values[i]; }

/// Four numbers in a row: g++ makes the best of them for every instruction set.
using Four [[gnu::vector_size(16)]] = float;
using FourAnywhere [[gnu::vector_size(16), gnu::aligned(4), gnu::may_alias]] = float;

inline Four mixed(Four a, Four b, float share) { return a + share * (b - a); }

/// Two entries in a row, of four numbers each.
#if defined(__AVX__)
using EightAnywhere [[gnu::vector_size(32), gnu::aligned(4), gnu::may_alias]] = float;
struct EntryPair {
  using Eight [[gnu::vector_size(32)]] = float;
  Eight both;
  explicit EntryPair(const float* at) : both(*reinterpret_cast<const EightAnywhere*>(at)) {}
  explicit EntryPair(Eight eight) : both(eight) {}
  Four first() const { return __builtin_shufflevector(both, both, 0, 1, 2, 3); }
  Four second() const { return __builtin_shufflevector(both, both, 4, 5, 6, 7); }
};
inline EntryPair mixed(EntryPair a, EntryPair b, float share) { return EntryPair(a.both + share * (b.both - a.both)); }
#else
struct EntryPair {
  Four low, high;
  explicit EntryPair(const float* at)
      : low(*reinterpret_cast<const FourAnywhere*>(at)), high(*reinterpret_cast<const FourAnywhere*>(at + 4)) {}
  EntryPair(Four low_, Four high_) : low(low_), high(high_) {}
  Four first() const { return low; }
  Four second() const { return high; }
};
inline EntryPair mixed(EntryPair a, EntryPair b, float share) {
  return {mixed(a.low, b.low, share), mixed(a.high, b.high, share)};
}
#endif

/// Between the two entries from `at` on and their neighbours at `step`.
inline EntryPair pairBetween(const float* at, std::int64_t step, float share) {
  return mixed(EntryPair(at), EntryPair(at + step), share);
}

inline void storeBetween(float* to, EntryPair pair, float share) {
  *reinterpret_cast<FourAnywhere*>(to) = mixed(pair.first(), pair.second(), share);
}

/// Where a number of [0, 1] lies among the entries of an axis: between `low` and the next, `share` of the way.
struct AxisPlace {
  Lanes::Int low;
  alignas(64) float share[Lanes::kLanes];
  AxisPlace(Lanes::Real unit, std::int32_t size) {
    using Real = Lanes::Real;
    const Real place = unit * Real(static_cast<float>(size - 1));
    const Real below = Lanes::toReal(Lanes::toInt(place)), last = Real(static_cast<float>(size - 2));
    const Real floor = Lanes::select(below < last, below, last);
    low = Lanes::toInt(floor);
    Lanes::store(share, place - floor);
  }
};

/// Four floats a lane.
struct RgbaRows {
  alignas(64) float at[4 * Lanes::kLanes];
  LaneColor lanes() const {
    std::int32_t offsets[Lanes::kLanes];
    for (std::size_t i = 0; i < Lanes::kLanes; ++i) offsets[i] = static_cast<std::int32_t>(4 * i);
    return loadColor(at, offsets);
  }
};

inline LaneColor fetchTable(const Table3d& table, Lanes::Real x, Lanes::Real y, Lanes::Real z) {
  const AxisPlace px(x, table.size[0]), py(y, table.size[1]), pz(z, table.size[2]);
  const Indices entry(px.low * Lanes::Int(table.step[0]) + py.low * Lanes::Int(table.step[1]) + pz.low);
  const std::int64_t stepX = 4 * std::int64_t{table.step[0]}, stepY = 4 * std::int64_t{table.step[1]};
  RgbaRows rows;
  for (std::size_t i = 0; i < Lanes::kLanes; ++i) {
    const float* const at = table.values + 4 * std::int64_t{entry.at[i]};
    const EntryPair low = pairBetween(at, stepY, py.share[i]), high = pairBetween(at + stepX, stepY, py.share[i]);
    storeBetween(rows.at + 4 * i, mixed(low, high, px.share[i]), pz.share[i]);
  }
  return rows.lanes();
}

inline LaneColor fetchTable(const Table2d& table, Lanes::Real x, Lanes::Real y) {
  const AxisPlace px(x, table.size[0]), py(y, table.size[1]);
  const Indices entry(px.low * Lanes::Int(table.step[0]) + py.low);
  const std::int64_t stepX = 4 * std::int64_t{table.step[0]};
  RgbaRows rows;
  for (std::size_t i = 0; i < Lanes::kLanes; ++i) {
    const EntryPair pair = pairBetween(table.values + 4 * std::int64_t{entry.at[i]}, stepX, px.share[i]);
    storeBetween(rows.at + 4 * i, pair, py.share[i]);
  }
  return rows.lanes();
}

}  // namespace
}  // namespace havs
