#pragma once
#include <span>
#include <vector>

#include "core/parallel.h"
#include "mesh/tet_mesh.h"

namespace havs {

/// A point on an edge whose ends have levels of both signs: near + share * (far - near).
struct EdgePoint {
  Index near, far;
  double share;  ///< (0, 1/2]
  /// Depends on the ends and not on which is first: at the middle neither is nearer.
  template <class Value>
  Value between(const Value& atNear, const Value& atFar) const {
    return share == 0.5 ? 0.5 * (atNear + atFar) : atNear + share * (atFar - atNear);
  }
};

/// What becomes of a cell.
enum class CellFate : unsigned char {
  goes,   ///< left out
  stays,  ///< on one side; in pieces only where a neighbour is split at an edge that they share
  split,  ///< at level 0; the pieces on both sides stay
  above   ///< split, and only the pieces above 0 stay
};

/// A mesh that is part of another, in pieces of its cells: where its points and cells come from.
struct MeshCut {
  std::vector<Tetrahedron> tetrahedra;
  std::vector<Index> cells;            ///< of each, the old cell that it is (a piece of); ascending
  std::vector<Index> keptPoints;       ///< old numbers of the first points, ascending
  std::vector<EdgePoint> edgePoints;   ///< the points after these, in old numbers
  std::vector<signed char> pieceSide;  ///< of each cell, the sign of its levels; 0: they are 0, or of both signs

  std::size_t pointCount() const { return keptPoints.size() + edgePoints.size(); }
  /// Values at the new points: kept, or interpolated along the edge. Parallel.
  template <class Value>
  std::vector<Value> pointValues(const std::vector<Value>& old) const;
  /// Values of the new cells: copied. Parallel.
  template <class Value>
  std::vector<Value> cellValues(const std::vector<Value>& old) const;
};

/// Cuts cells where a function changes its sign that is linear in each of them and has the given levels at the points.
/// fates: one a cell. New points lie where edges cross level 0, one for each edge, whatever the number of its cells, at
/// a place that depends on nothing but the edge and its levels; a point at level 0 is itself on the cut, and no new one
/// lies at it. What conforms before conforms after: faces that two cells share are cut alike. Pieces are right-handed
/// where their cells are; those of a cell follow each other in its place. Linear time but for sorting the crossed
/// edges, parallel; the same for any number of threads.
MeshCut cutMesh(std::span<const Tetrahedron> cells, std::span<const double> levels, std::span<const CellFate> fates);

template <class Value>
std::vector<Value> MeshCut::pointValues(const std::vector<Value>& old) const {
  std::vector<Value> values(pointCount());
  parallelFor(0, values.size(), 8192, [&](std::size_t i) {
    if (i < keptPoints.size()) {
      values[i] = old[keptPoints[i]];
    } else {
      const EdgePoint& point = edgePoints[i - keptPoints.size()];
      values[i] = point.between(old[point.near], old[point.far]);
    }
  });
  return values;
}

template <class Value>
std::vector<Value> MeshCut::cellValues(const std::vector<Value>& old) const {
  std::vector<Value> values(cells.size());
  parallelFor(0, values.size(), 8192, [&](std::size_t i) { values[i] = old[cells[i]]; });
  return values;
}

}  // namespace havs
