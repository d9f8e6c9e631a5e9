#include "render/native/table_layout.h"

#include <algorithm>

#include "core/parallel.h"

namespace havs {
namespace {

constexpr std::int32_t kLine = 4;  // entries of four floats in a cache line

std::int32_t padded(std::int32_t entries) { return (entries + kLine - 1) / kLine * kLine + kLine; }

}  // namespace

LaidOutTable layOut(ResourceTable table) {
  LaidOutTable made;
  std::copy(table.sizes.begin(), table.sizes.end(), made.sizes.begin());
  if (table.sizes.size() == 1) {
    made.steps[0] = 1;
    made.values = std::move(table.values);
    return made;
  }
  const auto [nx, ny, nz] = made.sizes;
  const bool deep = table.sizes.size() == 3;
  made.steps[2] = 1;
  made.steps[1] = deep ? padded(nz) : 1;
  made.steps[0] = deep ? padded(ny * made.steps[1]) : padded(ny);
  made.values.resize(4 * static_cast<std::size_t>(nx) * static_cast<std::size_t>(made.steps[0]));
  parallelFor(0, static_cast<std::size_t>(nx), 1, [&](std::size_t x) {
    for (std::int32_t y = 0; y < ny; ++y)
      for (std::int32_t z = 0; z < nz; ++z) {
        const auto from = static_cast<std::size_t>(z * ny + y) * static_cast<std::size_t>(nx) + x;
        const auto to = x * static_cast<std::size_t>(made.steps[0]) + static_cast<std::size_t>(y * made.steps[1] + z);
        std::copy_n(&table.values[4 * from], 4, &made.values[4 * to]);
      }
  });
  return made;
}

}  // namespace havs
