#include "scene/knots_in_cells.h"

#include <algorithm>

#include "scene/shown_scalars.h"

namespace havs {
namespace {

constexpr std::size_t kSampledCells = 4096;

}  // namespace

double meanKnotsInCells(const PreparedScene& prepared) {
  if (prepared.field.centering == Centering::cell) return 0;
  const ShownScalars shown(prepared.curve);
  const auto& knots = prepared.curve.knots;
  const auto& cells = prepared.mesh.tetrahedra;
  const std::size_t sampled = std::min(cells.size(), kSampledCells);
  std::size_t counted = 0, within = 0;
  for (std::size_t i = 0; i < sampled; ++i) {
    double low = 1, high = 0;
    for (const Index point : cells[i * cells.size() / sampled]) {
      low = std::min(low, prepared.scalars[point]);
      high = std::max(high, prepared.scalars[point]);
    }
    if (!shown.meet(low, high)) continue;
    const auto first = std::upper_bound(knots.begin(), knots.end(), low,
                                        [](double s, const ExtinctionCurve::Knot& knot) { return s < knot.s; });
    const auto last = std::lower_bound(first, knots.end(), high,
                                       [](const ExtinctionCurve::Knot& knot, double s) { return knot.s < s; });
    within += static_cast<std::size_t>(last - first);
    ++counted;
  }
  return counted == 0 ? 0 : static_cast<double>(within) / static_cast<double>(counted);
}

}  // namespace havs
