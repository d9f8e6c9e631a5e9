#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "scene/prepared_scene.h"

namespace havs {

/// A face of the mesh's boundary.
struct BoundaryFace {
  Index corners[3];  ///< ascending
  Vec3 normal;       ///< of length 1; 0 for a face without area
  /// Bit i: the edge from corner i to corner (i + 1) % 3 is drawn by the wire frame.
  std::uint8_t edges = 0;
  /// Bit i: corner i is the end of an edge that is drawn, so that a line does not break where other faces own it.
  std::uint8_t ends = 0;
};

/// The boundary faces, in the order of their numbers. `featureAngle`: WireFrame::featureAngle. Parallel.
std::vector<BoundaryFace> boundaryFaces(const PreparedScene& prepared, std::optional<double> featureAngle);

}  // namespace havs
