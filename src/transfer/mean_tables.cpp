#include "transfer/mean_tables.h"

#include <fmt/format.h>

#include <cmath>

#include "core/error.h"
#include "core/parallel.h"
#include "transfer/curve_change.h"
#include "transfer/layer_builder.h"

namespace havs {
namespace {

constexpr int kLargestSize2d = 4096;

void fill(MeanTable2d& table, const ExtinctionCurve& curve, const TouchedLines& touched) {
  const std::size_t size = table.size;
  const GridPieces grid(curve, table.size, kAddedExtinction);
  parallelBlocks(0, size, 8, [&](std::size_t first, std::size_t last) {
    LayerBuilder builder(grid, true);
    for (std::size_t span = first; span < last; ++span)
      builder.build(table.length, static_cast<int>(span), touched, [&](int front, int back, const Stretch& s) {
        float* const entry = &table.rgba[4 * (static_cast<std::size_t>(back) * size + static_cast<std::size_t>(front))];
        entry[0] = static_cast<float>(s.color.r / s.color.a);
        entry[1] = static_cast<float>(s.color.g / s.color.a);
        entry[2] = static_cast<float>(s.color.b / s.color.a);
        entry[3] = static_cast<float>(s.depth / table.length);
      });
  });
}

}  // namespace

MeanTable2d buildMeanTable2d(const ExtinctionCurve& curve, int size, double length) {
  if (size < 2 || size > kLargestSize2d)
    failInput(fmt::format("a table of {} entries along each axis", size), "table size", "choose 2 to 4096");
  if (!(length > 0 && std::isfinite(length))) failInput(fmt::format("length {} is not positive", length), "table");
  MeanTable2d table{.size = size, .length = length, .rgba = {}};
  table.rgba.resize(std::size_t{4} * size * size);
  fill(table, curve, {0, size - 1});
  return table;
}

void rebuildMeanTable2d(MeanTable2d& table, const ExtinctionCurve& before, const ExtinctionCurve& after) {
  fill(table, after, touchedLines(before, after, table.size));
}

}  // namespace havs
