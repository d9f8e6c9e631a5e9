#pragma once
#include <vector>

#include "mesh/tet_mesh.h"

namespace havs {

/// The frame that everything is drawn in: local = (world - center) / radius. All used points lie in the unit ball.
struct LocalFrame {
  Vec3 center{0};       ///< of the bounding box of the points that cells use
  double radius = 1;    ///< greatest distance of such a point from the centre; 1 when that is 0
  double diagonal = 2;  ///< of that bounding box, in world units
  Vec3 halfSize{0};     ///< the same: from its centre to its sides
  Vec3 toLocal(const Vec3& world) const { return (world - center) / radius; }
};

/// Safe for coordinates up to 1e300 and down to 1e-300.
LocalFrame localFrame(const TetMesh& mesh);
/// All points in the local frame (parallel).
std::vector<Vec3> localPoints(const TetMesh& mesh, const LocalFrame& frame);
/// The longest edge of any cell, in the local frame.
double longestEdge(const TetMesh& mesh, const std::vector<Vec3>& localPoints);

}  // namespace havs
