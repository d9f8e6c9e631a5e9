#pragma once
#include <span>
#include <vector>

#include "mesh/mesh_cut.h"

namespace havs {

/// The points p with dot(normal, p) >= offset, in the local frame; normal of length 1.
struct HalfSpace {
  Vec3 normal{0, 0, 1};
  double offset = 0;
  double level(const Vec3& p) const { return dot(normal, p) - offset; }
};

/// Points of the local frame that are nearer to the plane than this count as on it: no piece is thinner, so that the
/// rounding of places, 1e-16, turns none over. A picture in float does not show it: its places are good to 6e-8.
inline constexpr double kOnPlane = 1e-8;

/// Of each point (local frame), its distance from the plane, positive inside; 0 within kOnPlane. Parallel.
std::vector<double> levelsOf(std::span<const Vec3> localPoints, const HalfSpace& halfSpace);

/// The mesh within the half space: cells that cross the plane are cut at it, so that faces close the section, and what
/// lies beyond goes. Parallel, the same for any number of threads.
MeshCut partInside(std::span<const Tetrahedron> cells, std::span<const Vec3> localPoints, const HalfSpace& halfSpace);

}  // namespace havs
