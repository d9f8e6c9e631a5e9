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

/// Four numbers and eight in a row: g++ makes the best of them for every instruction set.
using Four [[gnu::vector_size(16)]] = float;
using Eight [[gnu::vector_size(32)]] = float;
using EightAnywhere [[gnu::vector_size(32), gnu::aligned(4), gnu::may_alias]] = float;
using FourAnywhere [[gnu::vector_size(16), gnu::aligned(4), gnu::may_alias]] = float;

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
inline Eight mixedPair(const float* at, std::int64_t step, float share) {
  const Eight low = *reinterpret_cast<const EightAnywhere*>(at);
  const Eight high = *reinterpret_cast<const EightAnywhere*>(at + step);
  return low + share * (high - low);
}

/// Between the first four and the last four.
inline void storeMixed(float* to, const Eight& pair, float share) {
  const Four low = __builtin_shufflevector(pair, pair, 0, 1, 2, 3);
  const Four high = __builtin_shufflevector(pair, pair, 4, 5, 6, 7);
  *reinterpret_cast<FourAnywhere*>(to) = low + share * (high - low);
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
  const Indices entry((pz.low * table.size[1] + py.low) * table.size[0] + px.low);
  const std::int64_t row = 4 * std::int64_t{table.size[0]}, slice = row * table.size[1];
  RgbaRows rows;
  for (std::size_t i = 0; i < SimdLanes::kLanes; ++i) {
    const float* const at = table.values + 4 * std::int64_t{entry.at[i]};
    const Eight near = mixedPair(at, row, py.share[i]);
    const Eight far = mixedPair(at + slice, row, py.share[i]);
    storeMixed(rows.at + 4 * i, near + pz.share[i] * (far - near), px.share[i]);
  }
  return rows.lanes();
}

inline RgbaLanes fetchTable(const Table2d& table, SimdLanes::Real x, SimdLanes::Real y) {
  const AxisPlace px(x, table.size[0]), py(y, table.size[1]);
  const Indices entry(py.low * table.size[0] + px.low);
  RgbaRows rows;
  for (std::size_t i = 0; i < SimdLanes::kLanes; ++i)
    storeMixed(rows.at + 4 * i,
               mixedPair(table.values + 4 * std::int64_t{entry.at[i]}, 4 * std::int64_t{table.size[0]}, py.share[i]),
               px.share[i]);
  return rows.lanes();
}

}  // namespace
}  // namespace havs
