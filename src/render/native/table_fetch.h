#pragma once
// What the lookups in shaders/ read, in lanes: numbers and texels by their number, tables filtered linearly.
#include "render/native/lookup_data.h"
#include "render/native/rgba_lanes.h"

namespace havs {
namespace {

using Texels = LookupData::Uniform;
struct Table2d : LookupData::Uniform {};
struct Table3d : LookupData::Uniform {};

inline RgbaLanes rgbaAt(const Texels& texels, SimdLanes::Int i) { return loadRgba(texels.values, Indices(4 * i).at); }
inline SimdLanes::Real numberAt(const Texels& texels, SimdLanes::Int i) { return SimdLanes::gather(texels.values, i); }
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

/// Where a number of [0, 1] lies among the entries of an axis: between `low` and the next, `share` of the way.
struct AxisPlace {
  SimdLanes::Int low;
  alignas(64) float share[SimdLanes::kLanes];
  AxisPlace(SimdLanes::Real unit, std::int32_t size) {
    using Real = SimdLanes::Real;
    const Real place = unit * Real(static_cast<float>(size - 1));
    const Real below = SimdLanes::toReal(SimdLanes::toInt(place)), last = Real(static_cast<float>(size - 2));
    const Real floor = SimdLanes::select(below < last, below, last);
    low = SimdLanes::toInt(floor);
    SimdLanes::store(share, place - floor);
  }
};

/// Between the two entries from `at` on and their neighbours at `step`.
inline EntryPair pairBetween(const float* at, std::int64_t step, float share) {
  return mixed(EntryPair(at), EntryPair(at + step), share);
}

inline void storeBetween(float* to, EntryPair pair, float share) {
  *reinterpret_cast<FourAnywhere*>(to) = mixed(pair.first(), pair.second(), share);
}

/// Four floats a lane.
struct RgbaRows {
  alignas(64) float at[4 * SimdLanes::kLanes];
  RgbaLanes lanes() const {
    std::int32_t offsets[SimdLanes::kLanes];
    for (std::size_t i = 0; i < SimdLanes::kLanes; ++i) offsets[i] = static_cast<std::int32_t>(4 * i);
    return loadRgba(at, offsets);
  }
};

inline RgbaLanes fetchTable(const Table3d& table, SimdLanes::Real x, SimdLanes::Real y, SimdLanes::Real z) {
  const AxisPlace px(x, table.size[0]), py(y, table.size[1]), pz(z, table.size[2]);
  const Indices entry(px.low * table.step[0] + py.low * table.step[1] + pz.low);
  const std::int64_t stepX = 4 * std::int64_t{table.step[0]}, stepY = 4 * std::int64_t{table.step[1]};
  RgbaRows rows;
  for (std::size_t i = 0; i < SimdLanes::kLanes; ++i) {
    const float* const at = table.values + 4 * std::int64_t{entry.at[i]};
    const EntryPair low = pairBetween(at, stepY, py.share[i]), high = pairBetween(at + stepX, stepY, py.share[i]);
    storeBetween(rows.at + 4 * i, mixed(low, high, px.share[i]), pz.share[i]);
  }
  return rows.lanes();
}

inline RgbaLanes fetchTable(const Table2d& table, SimdLanes::Real x, SimdLanes::Real y) {
  const AxisPlace px(x, table.size[0]), py(y, table.size[1]);
  const Indices entry(px.low * table.step[0] + py.low);
  RgbaRows rows;
  for (std::size_t i = 0; i < SimdLanes::kLanes; ++i)
    storeBetween(
        rows.at + 4 * i,
        pairBetween(table.values + 4 * std::int64_t{entry.at[i]}, 4 * std::int64_t{table.step[0]}, px.share[i]),
        py.share[i]);
  return rows.lanes();
}

}  // namespace
}  // namespace havs
