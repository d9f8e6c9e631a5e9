#include "app/mesh_quality.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/median.h"

namespace havs {
namespace {

using Corners = std::array<Vec3, 4>;

Range emptyRange() { return {std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()}; }

void include(Range& range, double value) {
  range.minimum = std::min(range.minimum, value);
  range.maximum = std::max(range.maximum, value);
}

Range edgeLengths(const Corners& p) {
  Range range = emptyRange();
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < i; ++j) include(range, std::hypot(p[i].x - p[j].x, p[i].y - p[j].y, p[i].z - p[j].z));
  return range;
}

double volumeOf(const Corners& p) { return std::abs(glm::dot(glm::cross(p[1] - p[0], p[2] - p[0]), p[3] - p[0])) / 6; }

/// Sum of the areas of the four faces.
double surfaceOf(const Corners& p) {
  auto area = [](const Vec3& a, const Vec3& b, const Vec3& c) { return 0.5 * glm::length(glm::cross(b - a, c - a)); };
  return area(p[0], p[1], p[2]) + area(p[0], p[1], p[3]) + area(p[0], p[2], p[3]) + area(p[1], p[2], p[3]);
}

/// Infinite for a flat cell. In units of the longest edge, as its cube may be too large or too small for a double.
double aspectRatioOf(Corners p, double longestEdge) {
  const Vec3 origin = p[0];
  for (Vec3& corner : p) corner = (corner - origin) / longestEdge;
  const double inscribedRadius = 3 * volumeOf(p) / surfaceOf(p);
  return 1 / (2 * std::sqrt(6.0) * inscribedRadius);
}

}  // namespace

MeshQuality measureQuality(const TetMesh& mesh) {
  MeshQuality quality{{Vec3{std::numeric_limits<double>::infinity()}, Vec3{-std::numeric_limits<double>::infinity()}},
                      emptyRange(),
                      emptyRange(),
                      emptyRange(),
                      0};
  std::vector<double> aspectRatios;
  bool any = false;
  for (const Tetrahedron& cell : mesh.tetrahedra) {
    const Corners p{mesh.points[cell[0]], mesh.points[cell[1]], mesh.points[cell[2]], mesh.points[cell[3]]};
    if (!std::all_of(p.begin(), p.end(), isFinite)) continue;
    any = true;
    for (const Vec3& corner : p)
      quality.bounds = {glm::min(quality.bounds[0], corner), glm::max(quality.bounds[1], corner)};
    const Range edges = edgeLengths(p);
    include(quality.edgeLength, edges.minimum);
    include(quality.edgeLength, edges.maximum);
    include(quality.volume, volumeOf(p));
    const double aspectRatio = aspectRatioOf(p, edges.maximum);
    if (std::isfinite(aspectRatio)) aspectRatios.push_back(aspectRatio);
  }
  if (!any) return {};
  if (aspectRatios.empty()) {
    quality.aspectRatio = {};
    return quality;
  }
  for (const double ratio : aspectRatios) include(quality.aspectRatio, ratio);
  quality.medianAspectRatio = medianOf(std::move(aspectRatios));
  return quality;
}

}  // namespace havs
