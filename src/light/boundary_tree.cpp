#include "light/boundary_tree.h"

#include <algorithm>

#include "core/parallel.h"
#include "mesh/spatial_order.h"

namespace havs {
namespace {

constexpr std::size_t kNodes = 2048;
/// By which boxes are widened: more than any rounding of places of the local frame, in the tree or in the rays that
/// look for faces.
constexpr double kMargin = 1e-9;

}  // namespace

BoundaryTree::Box BoundaryTree::around(const Vec3& low, const Vec3& high) {
  return {0.5 * (low + high), 0.5 * (high - low) + Vec3(kMargin)};
}

BoundaryTree::BoundaryTree(std::span<const Vec3> points, const Faces& faces) {
  std::vector<Index> boundary;
  for (std::size_t f = 0; f < faces.size(); ++f)
    if (faces.isBoundary(f)) boundary.push_back(static_cast<Index>(f));
  if (boundary.empty()) return;
  std::vector<Vec3> centers(boundary.size());
  parallelFor(0, boundary.size(), kNodes, [&](std::size_t i) {
    const auto [a, b, c] = faces.vertices[boundary[i]];
    centers[i] = (points[a] + points[b] + points[c]) / 3.0;
  });
  for (const Index i : spatialNumbers(centers, {}).points) faces_.push_back(boundary[i]);

  levels_.emplace_back((faces_.size() + kWidth - 1) / kWidth);
  parallelFor(0, levels_[0].size(), kNodes, [&](std::size_t box) {
    Vec3 low = points[faces.vertices[faces_[box * kWidth]][0]], high = low;
    for (std::size_t i = box * kWidth; i < std::min((box + 1) * kWidth, faces_.size()); ++i)
      for (const Index v : faces.vertices[faces_[i]]) {
        low = min(low, points[v]);
        high = max(high, points[v]);
      }
    levels_[0][box] = around(low, high);
  });
  while (levels_.back().size() > 1) addLevel();
}

void BoundaryTree::addLevel() {
  const std::vector<Box>& below = levels_.back();
  std::vector<Box> level((below.size() + kWidth - 1) / kWidth);
  parallelFor(0, level.size(), kNodes, [&](std::size_t box) {
    Vec3 low = below[box * kWidth].center, high = low;
    for (std::size_t i = box * kWidth; i < std::min((box + 1) * kWidth, below.size()); ++i) {
      low = min(low, below[i].center - below[i].half);
      high = max(high, below[i].center + below[i].half);
    }
    level[box] = around(low, high);
  });
  levels_.push_back(std::move(level));
}

double BoundaryTree::reach(const Vec3& from) const {
  if (faces_.empty()) return 0;
  const Box& root = levels_.back()[0];
  return length(from - root.center) + length(root.half);
}

}  // namespace havs
