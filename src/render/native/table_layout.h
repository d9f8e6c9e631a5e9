#pragma once
#include <array>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <vector>

#include "render/lookup_resources.h"

namespace havs {

struct FreeMemory {
  void operator()(float* memory) const { std::free(memory); }
};
/// Memory that is read here and there: where the system has them in large pages, so that fewer of them are looked up.
using ScatteredFloats = std::unique_ptr<float[], FreeMemory>;

/// A table in memory as the native device's kernels read it.
struct LaidOutTable {
  ScatteredFloats values;
  ScatteredFloats channels;                    ///< LookupData::Uniform::channels
  std::array<std::int32_t, 3> sizes{1, 1, 1};  ///< entries along each axis
  std::array<std::int32_t, 3> steps{};         ///< from an entry to its neighbour along each axis, in entries
};

/// Puts the entries of a table that is filtered along its last axis first. Over three axes that is the length: from
/// pixel to pixel of a face it goes through many entries, the scalars through few, so that neighbours find what they
/// read in the cache. Rows are padded by a cache line: with steps that are powers of two all entries of a column would
/// share the few places that a cache has for one address. A table that is read by number stays as it is. Throws
/// std::bad_alloc.
LaidOutTable layOut(const ResourceTable& table);

}  // namespace havs
