#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "scene/prepared_scene.h"

namespace havs {

/// A face of the mesh's boundary.
struct BoundaryFace {
  Index corners[3];  ///< ascending
  Vec3 normal;       ///< out of the mesh, of length 1; 0 for a face without area
};

/// The boundary faces, in the order of their numbers.
std::vector<BoundaryFace> boundaryFaces(const PreparedScene& prepared);

/// An edge as one of its faces has it.
struct EdgeOfFace {
  Index from, to;      ///< from < to
  std::uint32_t face;  ///< of boundaryFaces
  bool sameEdge(const EdgeOfFace& other) const { return from == other.from && to == other.to; }
};

/// The edges that WireFrame::featureAngle leaves, by the points where they end.
class FeatureEdges {
 public:
  FeatureEdges(const std::vector<BoundaryFace>& faces, std::size_t points, double angle);
  /// As each of their faces has them.
  const std::vector<EdgeOfFace>& all() const { return edges_; }
  /// Numbers of those in all() that end at a point.
  std::span<const std::uint32_t> at(Index point) const {
    return {ofPoints_.data() + begin_[point], ofPoints_.data() + begin_[point + 1]};
  }

 private:
  std::vector<EdgeOfFace> edges_;
  std::vector<std::uint32_t> begin_, ofPoints_;
};

}  // namespace havs
