#pragma once
#include <span>
#include <vector>

#include "mesh/tet_mesh.h"

namespace havs {

/// Numbers that put what lies near in space near in memory, however a mesh generator numbered it: along a Morton curve
/// (Morton 1966) through the box of the points that are finite, 10 bits an axis; equal places in the order they had.
/// New number to old one. Points that are not finite come anywhere. Parallel, the same for any number of threads.
struct SpatialNumbers {
  std::vector<Index> points;
  std::vector<Index> cells;  ///< by the mean of their points
};
SpatialNumbers spatialNumbers(std::span<const Vec3> points, std::span<const Tetrahedron> tetrahedra);

/// The points and cells of `mesh` in these numbers: neither its fields nor its notes. Parallel.
TetMesh renumbered(const TetMesh& mesh, const SpatialNumbers& numbers);

/// values[numbers[i]] for each i. Parallel.
std::vector<double> renumbered(const std::vector<double>& values, const std::vector<Index>& numbers);

}  // namespace havs
