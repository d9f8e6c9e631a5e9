// The table of the paper, and the one of mean colours: layers of one length each (layer_builder.h).
#include <fmt/format.h>

#include <cmath>
#include <mutex>

#include "core/error.h"
#include "core/parallel.h"
#include "transfer/curve_change.h"
#include "transfer/layer_builder.h"
#include "transfer/mean_tables.h"
#include "transfer/preintegration.h"

namespace havs {
namespace {

constexpr int kLargestSize3d = 512;
/// Where a segment has no length, its mean colour is the limit for short ones.
constexpr double kShortest = 1e-9;

void requireSizeAndLength(int size, double length) {
  if (size < 2 || size > kLargestSize3d)
    failInput(fmt::format("a table of {} entries along each axis", size), "table size", "choose 2 to 512");
  if (!(length > 0 && std::isfinite(length))) failInput(fmt::format("length {} is not positive", length), "table");
}

void storePremultiplied(const Stretch& s, float* entry) {
  entry[0] = static_cast<float>(s.color.r);
  entry[1] = static_cast<float>(s.color.g);
  entry[2] = static_cast<float>(s.color.b);
  entry[3] = static_cast<float>(s.color.a);
}

void storeMean(const Stretch& s, float* entry) {
  entry[0] = static_cast<float>(s.color.r / s.color.a);
  entry[1] = static_cast<float>(s.color.g / s.color.a);
  entry[2] = static_cast<float>(s.color.b / s.color.a);
  entry[3] = 1;
}

/// Builds the touched entries of a table, whose size and length are set and whose others stay.
template <class Store>
void fill(Table3d& table, const GridPieces& grid, const TouchedLines& touched, double shortest, const Store& store,
          const Progress& progress) {
  const std::size_t size = table.size, lengths = table.lengths;
  std::mutex progressMutex;
  int done = 0;
  parallelBlocks(0, lengths, 1, [&](std::size_t first, std::size_t last) {
    LayerBuilder builder(grid);
    for (std::size_t l = first; l < last; ++l) {
      float* const layer = &table.rgba[4 * size * size * l];
      const double share = std::max(static_cast<double>(l) / static_cast<double>(lengths - 1), shortest);
      for (int span = 0; span < table.size; ++span)
        builder.build(table.maximumLength * share, span, touched, [&](int front, int back, const Stretch& s) {
          store(s, layer + 4 * (static_cast<std::size_t>(back) * size + static_cast<std::size_t>(front)));
        });
      if (!progress) continue;
      const std::lock_guard lock(progressMutex);
      progress("table", static_cast<double>(++done) / static_cast<double>(lengths));
    }
  });
}

Table3d emptyTable(int size, int lengths, double maximumLength) {
  Table3d table{.size = size, .lengths = lengths, .maximumLength = maximumLength, .rgba = {}};
  table.rgba.resize(std::size_t{4} * size * size * lengths);
  return table;
}

void fillColors(Table3d& table, const ExtinctionCurve& curve, const TouchedLines& touched, const Progress& progress) {
  fill(table, GridPieces(curve, table.size), touched, 0, storePremultiplied, progress);
}

void fillMeans(Table3d& table, const ExtinctionCurve& curve, const TouchedLines& touched, const Progress& progress) {
  fill(table, GridPieces(curve, table.size, kAddedExtinction), touched, kShortest, storeMean, progress);
}

}  // namespace

Table3d buildTable3d(const ExtinctionCurve& curve, int size, double maximumLength, const Progress& progress) {
  requireSizeAndLength(size, maximumLength);
  Table3d table = emptyTable(size, size, maximumLength);
  fillColors(table, curve, {0, size - 1}, progress);
  return table;
}

Table3d buildMeanColors(const ExtinctionCurve& curve, int size, double maximumLength, const Progress& progress) {
  requireSizeAndLength(size, maximumLength);
  Table3d table = emptyTable(2 * size, std::max(2, size / 4), maximumLength);
  fillMeans(table, curve, {0, table.size - 1}, progress);
  return table;
}

void rebuildTable3d(Table3d& table, const ExtinctionCurve& before, const ExtinctionCurve& after) {
  fillColors(table, after, touchedLines(before, after, table.size), {});
}

void rebuildMeanColors(Table3d& table, const ExtinctionCurve& before, const ExtinctionCurve& after) {
  fillMeans(table, after, touchedLines(before, after, table.size), {});
}

}  // namespace havs
