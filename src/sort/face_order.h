#pragma once
#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/vec.h"
#include "mesh/faces.h"

namespace havs {

/// Where the picture is taken from, in the local frame.
struct ViewPoint {
  bool orthographic = false;
  Vec3 eye{0};        ///< perspective: where the rays start
  Vec3 direction{0};  ///< unit vector along the view, away from the eye (orthographic: of every ray)
  /// For faces whose plane goes through the eye to within rounding: on which side of it the picture, whose points are
  /// rounded in their own way, sees the eye. 1: the corners a, b, c turn right-handed towards it; -1; 0: on the plane.
  /// Empty: such faces count as seen edge on.
  std::function<int(const Vec3& a, const Vec3& b, const Vec3& c)> sideInPicture{};
  /// Of the place and direction.
  bool operator==(const ViewPoint& other) const {
    return orthographic == other.orthographic && eye == other.eye && direction == other.direction;
  }
};

/// Faces, near first.
struct FaceOrder {
  std::vector<Index> faces;
  std::size_t cycles = 0;  ///< visibility cycles that were cut (topological only)
};

/// One way to order the faces of one mesh; keeps what it can between views.
class FaceSorter {
 public:
  virtual ~FaceSorter() = default;
  /// Writes all faces, near first, into `order` (its memory is used again). Deterministic for any number of threads.
  virtual void sort(const ViewPoint& view, FaceOrder& order) = 0;
  /// To be called where the order for `view` has turned out wrong somewhere: writes a better one and goes on like that,
  /// or returns false where none is known.
  virtual bool refine(const ViewPoint& view, FaceOrder& order) {
    static_cast<void>(view), static_cast<void>(order);
    return false;
  }
  /// The same, handed over in pieces: `ready(count)` is called with growing counts, the last that of all faces, when
  /// order.faces[0 .. count) are written for good. order.faces has its full size from the first call on, so nothing
  /// moves. The calls come one after another, but maybe from other threads; they should return soon. What they throw is
  /// rethrown. Orders that are known only as a whole call it once.
  virtual void sortInPieces(const ViewPoint& view, FaceOrder& order, const std::function<void(std::size_t)>& ready) {
    sort(view, order);
    ready(order.faces.size());
  }
};

/// What a sorter works on; all must outlive it. Points in the local frame, cells right-handed (repairMesh).
struct SortInput {
  std::span<const Vec3> points;
  std::span<const Tetrahedron> tetrahedra;
  const Faces* faces = nullptr;
};

/// One row of the table of orders (`--sort`).
struct SortMethod {
  std::string name;
  std::string description;
  std::unique_ptr<FaceSorter> (*make)(const SortInput&);
  bool usesNeighbours = false;  ///< follows the cells from one to the next, so that a mesh with gaps is harder
  bool isBelieved = false;      ///< tells which of two faces of a cell is in front, where distances are too rounded to
};
/// centroid, topological, exact (the comparison sort, the tests' oracle), none (the file's order).
std::span<const SortMethod> sortMethods();
/// Throws Error{input} for an unknown name, naming the nearest.
const SortMethod& sortMethod(const std::string& name);

}  // namespace havs
