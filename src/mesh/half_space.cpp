#include "mesh/half_space.h"

#include <algorithm>
#include <cmath>

#include "core/parallel.h"

namespace havs {

std::vector<double> levelsOf(std::span<const Vec3> localPoints, const HalfSpace& halfSpace) {
  std::vector<double> levels(localPoints.size());
  parallelFor(0, levels.size(), kGrain, [&](std::size_t p) {
    const double level = halfSpace.level(localPoints[p]);
    levels[p] = std::abs(level) > kOnPlane ? level : 0.0;
  });
  return levels;
}

MeshCut partInside(std::span<const Tetrahedron> cells, std::span<const Vec3> localPoints, const HalfSpace& halfSpace) {
  const std::vector<double> levels = levelsOf(localPoints, halfSpace);
  std::vector<CellFate> fates(cells.size());
  parallelFor(0, cells.size(), kGrain, [&](std::size_t c) {
    const auto& [i, j, k, l] = cells[c];
    const auto [least, most] = std::minmax({levels[i], levels[j], levels[k], levels[l]});
    fates[c] = !(most > 0) ? CellFate::goes : least < 0 ? CellFate::above : CellFate::stays;
  });
  return cutMesh(cells, levels, fates);
}

}  // namespace havs
