#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "light/line_triangle.h"

namespace havs {

/// A cell with the cell across the face opposite to each of its vertices; kNoIndex where that is boundary.
struct LinkedCell {
  Tetrahedron points;
  std::array<Index, 4> across;
};

/// The cells around a point, as rays that start there see them. Can be used again for another point.
class Star {
 public:
  /// `around`: the cells that have `point`.
  void gather(Index point, std::span<const Index> around, std::span<const Node> nodes,
              std::span<const LinkedCell> cells);

  const Node& node() const { return node_; }
  /// Into the mesh: against the sum of the normals, as long as the areas, of the boundary faces at the point; 0 inside.
  const Vec3& inward() const { return inward_; }

  /// The cell into which a ray from the point goes, kNoIndex where it goes into none, and where it leaves that cell.
  struct Exit {
    Index cell = kNoIndex;
    Index next = kNoIndex;  ///< the cell behind the triangle
    LineTriangle triangle;
  };
  /// `line` must start at the point. Not to be called from several threads at once.
  Exit leave(const LineFrame& line);

 private:
  struct Link {
    std::array<std::uint32_t, 3> corner;  ///< places in rim_, turning right-handed seen from the point
    Index cell, next;
  };
  std::uint32_t rimPlace(Index point, const Node& node);

  Node node_{};
  Vec3 inward_{0};
  std::vector<Link> links_;  ///< the faces opposite to the point
  struct RimPoint {
    Index point;
    Node node;
  };
  std::vector<RimPoint> rim_;
  std::vector<LinePoint> seen_;
};

}  // namespace havs
