#include "light/mesh_tracer.h"

#include <algorithm>
#include <cmath>

#include "core/parallel.h"

namespace havs {
namespace {

/// How far before the end of one stretch inside the mesh another may begin, for parts that touch: rounding decides
/// which comes first. It may be large: the stretch that has been followed already is known by the cell that it began
/// in.
constexpr double kTouch = 1e-6;
/// Optical depth from which exp(-depth) is 0.
constexpr double kDark = 746;

std::vector<Node> nodesOf(const Medium& medium) {
  std::vector<Node> nodes(medium.points.size());
  parallelFor(0, nodes.size(), kGrain, [&](std::size_t p) {
    nodes[p] = {medium.points[p], medium.cellData ? 0 : medium.scalars[p]};
  });
  return nodes;
}

std::vector<LinkedCell> linkedCells(const Medium& medium) {
  const Faces& faces = medium.faces;
  std::vector<LinkedCell> cells(medium.cells.size());
  parallelFor(0, cells.size(), kGrain, [&](std::size_t c) {
    cells[c].points = medium.cells[c];
    for (std::size_t i = 0; i < 4; ++i) {
      const auto& [first, second] = faces.cells[faces.ofCell[c][i]];
      cells[c].across[i] = first == c ? second : first;
    }
  });
  return cells;
}

/// The part of a stretch inside one cell that lies from `from` to `to`. Its length may be negative: where rounding puts
/// a face seen edge-on before the last one, the next cell takes back what was too much.
struct Part {
  double r0, r1, s0, s1;
  template <class Crossing>
  Part(const Crossing& front, const Crossing& back, double from, double to)
      : r0(std::clamp(front.along, from, to)), r1(std::clamp(back.along, from, to)), s0(front.scalar), s1(back.scalar) {
    if (empty()) return;
    const double perLength = (back.scalar - front.scalar) / (back.along - front.along);
    if (r0 != front.along) s0 = std::clamp(front.scalar + (r0 - front.along) * perLength, 0.0, 1.0);
    if (r1 != back.along) s1 = std::clamp(back.scalar - (back.along - r1) * perLength, 0.0, 1.0);
  }
  bool empty() const { return r0 == r1; }
};

/// Optical depth from `from` to `to`; `enough` ends the search.
struct DepthSums {
  const ExtinctionIntegral& extinction;
  double from, to, enough;
  double depth = 0;

  DepthSums another() const { return {extinction, from, to, enough}; }
  bool join(const DepthSums& path) {
    depth += path.depth;
    return depth < enough;
  }
  bool add(const Part& part) {
    if (extinction.isOpaque(part.s0, part.s1)) {
      depth = PointRays::kEndless;
      return false;
    }
    depth += (part.r1 - part.r0) * extinction.mean(part.s0, part.s1);
    return depth < enough;
  }
};

/// Optical depth and the moment of a ball of radius `to`.
struct BallSums {
  const ExtinctionIntegral& extinction;
  double from, to;
  PointRays::BallRay ray;

  BallSums another() const { return {extinction, from, to, {}}; }
  bool join(const BallSums& path) {
    ray.opticalDepth += path.ray.opticalDepth;
    ray.moment += path.ray.moment;
    return true;
  }
  bool add(const Part& part) {
    ray.opticalDepth += extinction.isOpaque(part.s0, part.s1) ? PointRays::kEndless
                                                              : (part.r1 - part.r0) * extinction.mean(part.s0, part.s1);
    ray.moment += extinction.secondMoment(part.r0, part.r1, part.s0, part.s1);
    return true;
  }
};

}  // namespace

MeshTracer::MeshTracer(const Medium& medium)
    : medium_(medium),
      extinction_(medium.curve),
      nodes_(nodesOf(medium)),
      cells_(linkedCells(medium)),
      around_(medium.points.size(), medium.cells),
      boundary_(medium.points, medium.faces) {}

/// Where a ray leaves or enters `cell` through a triangle.
MeshTracer::Crossing MeshTracer::crossing(const LineTriangle& triangle, Index cell) const {
  const auto [a, b, c] = triangle.shares();
  const auto& [p, q, r] = triangle.corner;
  const double along = a * p.along + b * q.along + c * r.along;
  if (medium_.cellData) return {along, medium_.scalars[cell]};
  return {along, a * p.scalar + b * q.scalar + c * r.scalar};
}

/// Follows the ray from cell to cell, from where it enters `cell` through `triangle` at `at`, and adds what lies inside
/// them, until it leaves the mesh (`at` is where), the sums have enough or `start` is reached. It comes to an end: a
/// ray goes through none or two faces of a cell, and a face has two cells at most, so that cells and faces along a ray
/// make chains; one that begins at the boundary ends there, one through `start` ends there or comes back to it.
template <class Sums>
MeshTracer::Ended MeshTracer::walk(const LineFrame& line, LineTriangle& triangle, Crossing& at, Index cell, Index start,
                                   Sums& sums) const {
  const auto& corner = triangle.corner;
  while (cell != kNoIndex) {
    if (cell == start) return Ended::atStart;
    const auto& [v, across] = cells_[cell];
    const Index apex = v[0] ^ v[1] ^ v[2] ^ v[3] ^ corner[0].point ^ corner[1].point ^ corner[2].point;
    const Index passed = triangle.passCell(line.see(nodes_[apex], apex));
    if (passed == kNoIndex) return Ended::outside;
    const Crossing next = crossing(triangle, cell);
    if (medium_.cellData) at.scalar = next.scalar;
    const Part part(at, next, sums.from, sums.to);
    if (!part.empty() && !sums.add(part)) return Ended::early;
    if (next.along >= sums.to) return Ended::early;
    at = next;
    cell = across[v[0] == passed ? 0 : v[1] == passed ? 1 : v[2] == passed ? 2 : 3];
  }
  return Ended::outside;
}

template <class Sums>
void MeshTracer::trace(Star& star, const Vec3& direction, Sums& sums) const {
  const LineFrame line(star.node().position, direction, star.inward());
  Star::Exit first = star.leave(line);
  double left = 0;
  if (first.cell != kNoIndex) {
    Crossing at = crossing(first.triangle, first.cell);
    const Crossing start{0, medium_.cellData ? at.scalar : star.node().scalar};
    const Part part(start, at, sums.from, sums.to);
    if (!part.empty() && !sums.add(part)) return;
    if (at.along >= sums.to) return;
    if (walk(line, first.triangle, at, first.next, first.cell, sums) == Ended::early) return;
    left = std::max(0.0, at.along);
  }
  // Depths add up, so that it does not matter in which order the ray comes to the other parts.
  const double last = std::min(sums.to, boundary_.reach(line.start()));
  if (!(left < last)) return;
  const auto place = [&](double along) { return line.start() + along * direction; };
  boundary_.visitNear(place(left - kTouch), place(last), [&](Index face) {
    const auto [a, b, c] = medium_.faces.vertices[face];
    const auto see = [&](Index p) { return line.see(nodes_[p], p); };
    LineTriangle triangle{{see(a), see(c), see(b)}, {}};  // the ray goes in where the normal goes out
    if (!triangle.isHit()) return true;
    const Index cell = medium_.faces.cells[face][0];
    Crossing at = crossing(triangle, cell);
    if (at.along < left - kTouch || at.along >= sums.to) return true;
    Sums path = sums.another();
    if (walk(line, triangle, at, cell, first.cell, path) == Ended::atStart) return true;
    return sums.join(path);
  });
}

void PointRays::startAt(Index point) { star_.gather(point, tracer_.around_.of(point), tracer_.nodes_, tracer_.cells_); }

double PointRays::opticalDepth(const Vec3& direction, double from, double to) {
  if (!(from < to)) return 0;
  DepthSums sums{tracer_.extinction_, from, to, kEndless};
  tracer_.trace(star_, direction, sums);
  return std::max(0.0, sums.depth);
}

double PointRays::transmittance(const Vec3& direction, double from, double to) {
  if (!(from < to)) return 1;
  DepthSums sums{tracer_.extinction_, from, to, kDark};
  tracer_.trace(star_, direction, sums);
  return std::exp(-std::max(0.0, sums.depth));
}

PointRays::BallRay PointRays::ballRay(const Vec3& direction, double radius) {
  BallSums sums{tracer_.extinction_, 0, radius, {}};
  tracer_.trace(star_, direction, sums);
  return {std::max(0.0, sums.ray.opticalDepth), std::max(0.0, sums.ray.moment)};
}

}  // namespace havs
