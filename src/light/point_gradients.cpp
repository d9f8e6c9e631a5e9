#include "light/point_gradients.h"

#include <algorithm>
#include <cmath>

#include "core/parallel.h"
#include "mesh/face_matching.h"

namespace havs {
namespace {

constexpr std::size_t kPointsOfBlock = 1024;
/// Volume of a cell that counts as flat, in cubes of its longest edge (mesh/defects.h).
constexpr double kFlat = 1e-15;

/// A cell as seen from one of its points: the other three turn right-handed.
struct Corner {
  std::array<Index, 3> point;
  std::array<Vec3, 3> offset;

  Corner(Index from, const Tetrahedron& cell, std::span<const Vec3> points) {
    std::size_t place = 0;
    while (place < 3 && cell[place] != from) ++place;
    point = outwardFace(cell, place);
    for (std::size_t i = 0; i < 3; ++i) offset[i] = points[point[i]] - points[from];
  }
  double sixVolumes() const { return dot(offset[0], cross(offset[1], offset[2])); }
  double longestSquared() const {
    return std::max({dot(offset[0], offset[0]), dot(offset[1], offset[1]), dot(offset[2], offset[2])});
  }
};

/// Sums over cells; with differences from the value at the point itself nothing large cancels.
Vec3 gradientAt(Index p, std::span<const Vec3> points, std::span<const Tetrahedron> cells,
                std::span<const Index> around, std::span<const double> values) {
  Vec3 sum{0};
  double weight = 0, flat = 0;
  for (const Index c : around) {
    const Corner corner(p, cells[c], points);
    const auto& [a, b, d] = corner.offset;
    const double distance = length(a + b + d);
    if (!(distance > 0)) continue;  // a flat cell about the point
    const double near = 1 / (distance * distance * distance);
    const auto rise = [&](std::size_t i) { return values[corner.point[i]] - values[p]; };
    sum += near * (rise(0) * cross(b, d) + rise(1) * cross(d, a) + rise(2) * cross(a, b));
    weight += near * corner.sixVolumes();
    const double squared = corner.longestSquared();
    flat += near * 6 * kFlat * squared * std::sqrt(squared);
  }
  return weight > flat ? sum / weight : Vec3(0);
}

}  // namespace

std::vector<double> pointAverages(std::span<const Vec3> points, std::span<const Tetrahedron> cells,
                                  const PointCells& around, std::span<const double> cellScalars) {
  std::vector<double> values(points.size(), 0.0);
  parallelFor(0, points.size(), kPointsOfBlock, [&](std::size_t p) {
    double sum = 0, weight = 0, plainSum = 0;
    for (const Index c : around.of(p)) {
      const double volume = std::max(0.0, Corner(static_cast<Index>(p), cells[c], points).sixVolumes());
      sum += volume * cellScalars[c];
      weight += volume;
      plainSum += cellScalars[c];
    }
    const std::size_t count = around.of(p).size();
    if (count > 0) values[p] = weight > 0 ? sum / weight : plainSum / static_cast<double>(count);
  });
  return values;
}

std::vector<Vec3> pointGradients(std::span<const Vec3> points, std::span<const Tetrahedron> cells,
                                 const PointCells& around, std::span<const double> scalars, bool cellData,
                                 PointMask mask) {
  std::vector<double> averages;
  if (cellData) averages = pointAverages(points, cells, around, scalars);
  const std::span<const double> values = cellData ? std::span<const double>(averages) : scalars;
  std::vector<Vec3> gradients(points.size(), Vec3(0));
  parallelFor(0, points.size(), kPointsOfBlock, [&](std::size_t p) {
    if (isIn(mask, p)) gradients[p] = gradientAt(static_cast<Index>(p), points, cells, around.of(p), values);
  });
  return gradients;
}

}  // namespace havs
