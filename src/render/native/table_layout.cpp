#include "render/native/table_layout.h"

#if defined(__linux__)
#include <sys/mman.h>
#endif

#include <algorithm>
#include <new>

#include "core/parallel.h"
#include "render/native/lookup_data.h"

namespace havs {
namespace {

constexpr std::size_t kLineBytes = 64;
constexpr std::int32_t kLineEntries = 4;
constexpr std::size_t kLargePage = std::size_t{1} << 21;

std::int32_t padded(std::int32_t entries) {
  return (entries + kLineEntries - 1) / kLineEntries * kLineEntries + kLineEntries;
}

ScatteredFloats allocate(std::size_t count) {
  const std::size_t bytes = count * sizeof(float);
  const std::size_t page = bytes < kLargePage ? kLineBytes : kLargePage;
  const std::size_t whole = (bytes + page - 1) / page * page;
  ScatteredFloats memory(static_cast<float*>(std::aligned_alloc(page, whole)));
  if (!memory) throw std::bad_alloc();
#if defined(__linux__)
  if (page == kLargePage) madvise(memory.get(), whole, MADV_HUGEPAGE);  // a wish: without it, it is only slower
#endif
  return memory;
}

}  // namespace

LaidOutTable layOut(const ResourceTable& table) {
  LaidOutTable made;
  std::copy(table.sizes.begin(), table.sizes.end(), made.sizes.begin());
  if (table.sizes.size() == 1) {
    made.values = allocate(table.values.size());
    std::copy(table.values.begin(), table.values.end(), made.values.get());
    const auto entries = static_cast<std::size_t>(made.sizes[0]);
    if (entries <= kSmallTable && table.values.size() == 4 * entries) {
      made.channels = allocate(4 * std::size_t{kSmallTable});
      std::fill_n(made.channels.get(), 4 * std::size_t{kSmallTable}, 0.0f);
      for (std::size_t i = 0; i < table.values.size(); ++i)
        made.channels[i % 4 * kSmallTable + i / 4] = table.values[i];
    }
    return made;
  }
  const auto [nx, ny, nz] = made.sizes;
  const bool deep = table.sizes.size() == 3;
  made.steps[2] = 1;
  made.steps[1] = deep ? padded(nz) : 1;
  made.steps[0] = deep ? padded(ny * made.steps[1]) : padded(ny);
  made.values = allocate(4 * static_cast<std::size_t>(nx) * static_cast<std::size_t>(made.steps[0]));
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
