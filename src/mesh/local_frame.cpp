#include "mesh/local_frame.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/parallel.h"

namespace havs {
namespace {

struct Bounds {
  Vec3 low{std::numeric_limits<double>::infinity()};
  Vec3 high{-std::numeric_limits<double>::infinity()};
};

/// Largest value of measure(cell) over all cells, at least 0.
template <class Measure>
double greatest(const TetMesh& mesh, const Measure& measure) {
  return parallelReduce(
      0, mesh.tetrahedra.size(), kGrain, 0.0,
      [&](std::size_t first, std::size_t last) {
        double most = 0;
        for (std::size_t c = first; c < last; ++c) most = std::max(most, measure(mesh.tetrahedra[c]));
        return most;
      },
      [](double a, double b) { return std::max(a, b); });
}

Bounds boundingBox(const TetMesh& mesh) {
  return parallelReduce(
      0, mesh.tetrahedra.size(), kGrain, Bounds{},
      [&](std::size_t first, std::size_t last) {
        Bounds box;
        for (std::size_t c = first; c < last; ++c)
          for (const Index v : mesh.tetrahedra[c]) {
            box.low = min(box.low, mesh.points[v]);
            box.high = max(box.high, mesh.points[v]);
          }
        return box;
      },
      [](const Bounds& a, const Bounds& b) {
        return Bounds{min(a.low, b.low), max(a.high, b.high)};
      });
}

}  // namespace

LocalFrame localFrame(const TetMesh& mesh) {
  LocalFrame frame;
  if (mesh.tetrahedra.empty()) return frame;
  const Bounds box = boundingBox(mesh);
  frame.center = box.low / 2.0 + box.high / 2.0;  // their sum may overflow
  const Vec3 half = frame.halfSize = box.high / 2.0 - box.low / 2.0;
  // Lengths are squared only after division by this one, so that nothing overflows or underflows.
  const double scale = std::max({half.x, half.y, half.z});
  if (!(scale > 0)) {
    frame.diagonal = 0;
    return frame;
  }
  const double squared = greatest(mesh, [&](const Tetrahedron& cell) {
    double most = 0;
    for (const Index v : cell) {
      const Vec3 q = (mesh.points[v] - frame.center) / scale;
      most = std::max(most, dot(q, q));
    }
    return most;
  });
  frame.radius = scale * std::sqrt(squared);
  frame.diagonal = 2 * scale * length(half / scale);
  return frame;
}

std::vector<Vec3> localPoints(const TetMesh& mesh, const LocalFrame& frame) {
  std::vector<Vec3> points(mesh.points.size());
  parallelFor(0, points.size(), kGrain, [&](std::size_t i) { points[i] = frame.toLocal(mesh.points[i]); });
  return points;
}

double longestEdge(const TetMesh& mesh, const std::vector<Vec3>& points) {
  return std::sqrt(greatest(mesh, [&](const Tetrahedron& cell) {
    double most = 0;
    for (int i = 0; i < 3; ++i)
      for (int j = i + 1; j < 4; ++j) {
        const Vec3 edge = points[cell[static_cast<std::size_t>(j)]] - points[cell[static_cast<std::size_t>(i)]];
        most = std::max(most, dot(edge, edge));
      }
    return most;
  }));
}

}  // namespace havs
