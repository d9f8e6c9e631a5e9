#pragma once
#include <span>
#include <vector>

#include "mesh/tet_mesh.h"

namespace havs {

/// The cells along a Morton curve through their centroids (Morton 1966), 10 bits an axis: neighbours in space are then
/// mostly neighbours in memory, however a mesh generator numbered them. Points in the local frame (coordinates in [-1,
/// 1]). Parallel, deterministic.
std::vector<Index> spatialOrder(std::span<const Vec3> points, std::span<const Tetrahedron> tetrahedra);

}  // namespace havs
