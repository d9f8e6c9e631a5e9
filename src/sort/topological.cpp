// The order by depth-first search (Williams 1992, "Visibility ordering meshed polyhedra", its MPVO order; here by
// post-order, near first). The plane of a face between two cells tells which of them is in front: the one on the eye's
// side. Follow that relation from a cell to the cells in front of it, and write each cell when all of these are
// written: no cell then comes before one that hides part of it. Every ray leaves the mesh somewhere, so the search
// starts at cells with a boundary face that rays leave through, near ones first: what a nearer part of a non-convex
// mesh consists of is written before the search reaches a part behind it. Where cells hide each other in a cycle, the
// relation across the face that shows smallest is ignored, and counted: every ray that does not pass that face still
// meets all cells in order. The search itself is in
// cell_search.h; this file tells it which cell is in front of which, and where to start. When neither has changed since
// the last view, its result stands.
#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>

#include "core/parallel.h"
#include "mesh/radix_sort.h"
#include "sort/cell_search.h"
#include "sort/distance_key.h"
#include "sort/face_pieces.h"
#include "sort/sorters.h"

namespace havs {
namespace {

constexpr std::size_t kCellsOfPiece = 16384;

/// On which side of a face, as oriented by Faces, the eye is.
enum class Side : std::int8_t { inside = -1, edgeOn = 0, outside = 1 };

/// The face's plane at the eye: `height` is six times the volume of face and eye, positive outside.
struct EyeHeight {
  double height;
  double boundSquared;  ///< of the rounding error
  Vec3 toEye;
};

EyeHeight eyeHeight(const Vec3& a, const Vec3& b, const Vec3& c, const ViewPoint& view) {
  const Vec3 ab = b - a, ac = c - a;
  const Vec3 toEye = view.orthographic ? -view.direction : view.eye - a;
  constexpr double kRounding = 8 * std::numeric_limits<double>::epsilon();  // of three products and their sums
  return {dot(cross(ab, ac), toEye), kRounding * kRounding * (dot(ab, ab) * dot(ac, ac) * dot(toEye, toEye)), toEye};
}

/// Outside: a ray through the face passes from cells[1] to cells[0]. Edge-on also where rounding hides the sign.
Side eyeSide(const EyeHeight& plane) {
  if (plane.height * plane.height <= plane.boundSquared) return Side::edgeOn;
  return plane.height > 0 ? Side::outside : Side::inside;
}

/// The heights of the eye over the planes of a cell's faces, all at once, positive outside of the cell.
struct CellHeights {
  std::array<double, 4> height;
  double doubt;  ///< what is greater has the sign that sideOf finds for the face
};

/// What the points of a picture may be off by, in their own place: a few roundings of their distance from the eye.
constexpr double kPictureRounding = 128 * std::numeric_limits<double>::epsilon();

double sizeOf(const Vec3& v) { return std::abs(v.x) + std::abs(v.y) + std::abs(v.z); }

/// Distance that a picture's rounding is relative to: of a point from the eye, or from the mesh's centre.
double reachOf(const Vec3& point, const Vec3& toEye, const ViewPoint& view) {
  return view.orthographic ? sizeOf(point) + 1 : sizeOf(toEye);
}

CellHeights cellHeights(std::span<const Vec3> points, const Tetrahedron& cell, const ViewPoint& view) {
  const Vec3& origin = points[cell[0]];
  const Vec3 a = points[cell[1]] - origin, b = points[cell[2]] - origin, c = points[cell[3]] - origin;
  const Vec3 toEye = view.orthographic ? -view.direction : view.eye - origin;
  const Vec3 ab = cross(a, b), bc = cross(b, c), ca = cross(c, a);  // into the cell, as it is right-handed
  const double volume = view.orthographic ? 0 : dot(ab, c);
  CellHeights result{{0, -dot(bc, toEye), -dot(ca, toEye), -dot(ab, toEye)}, 0};
  result.height[0] = -(result.height[1] + result.height[2] + result.height[3]) - volume;
  const double edges = sizeOf(a) + sizeOf(b) + sizeOf(c), reach = edges + reachOf(origin, toEye, view);
  // More than twice the bound of eyeHeight and the rounding of the sums above, which have a factor `edges` for one of
  // `reach`.
  result.doubt = kPictureRounding * edges * reach * reach;
  return result;
}

/// Grows with the area that the face takes of the picture.
double footprint(const EyeHeight& plane) {
  const double distance = length(plane.toEye);  // 1 for orthographic
  return std::abs(plane.height) / (distance * distance * distance);
}

std::vector<Neighbors> neighborsOf(const Faces& faces) {
  std::vector<Neighbors> neighbors(faces.ofCell.size());
  parallelFor(0, neighbors.size(), kGrain, [&](std::size_t cell) {
    for (std::size_t i = 0; i < 4; ++i) {
      const auto& [first, second] = faces.cells[faces.ofCell[cell][i]];
      neighbors[cell][i] = first == cell ? second : first;
    }
  });
  return neighbors;
}

/// Places in memory follow the numbers of the cells, so cells that lie near each other should have near numbers
/// (mesh/spatial_order.h).
class TopologicalSorter final : public FaceSorter {
 public:
  explicit TopologicalSorter(const SortInput& input);
  void sort(const ViewPoint& view, FaceOrder& order) override { sortInPieces(view, order, {}); }
  void sortInPieces(const ViewPoint& view, FaceOrder& order, const std::function<void(std::size_t)>& ready) override;

 private:
  struct BoundaryFace {
    Index face, cell;
  };

  EyeHeight eyeHeightOf(Index face) const;
  Side sideOf(Index face) const;
  bool findSides();
  bool findStarts();
  CellMarks marksOf(Index cell) const;
  void search(FacePieces& pieces);

  SortInput input_;
  ViewPoint view_;
  std::vector<Neighbors> neighbors_;
  std::vector<BoundaryFace> boundary_;
  std::vector<CellMarks> sides_;           ///< what the view says of each cell, before the search
  std::vector<Index> starts_;              ///< cells
  std::vector<CellMarks> marks_;           ///< the same, after it
  std::vector<Index> cells_;               ///< in the order of the last view
  std::vector<FacePieces::Piece> pieces_;  ///< of cells_
  CellSearch search_;
  /// Sides of the last view were asked of its picture (ViewPoint::sideInPicture): of another picture from the same
  /// place they may be others.
  mutable std::atomic<bool> askedPicture_ = false;
  bool isSearched_ = false;               ///< the search of these sides and starts came to its end
  std::vector<std::uint32_t> startKeys_;  ///< one a boundary face
  std::vector<KeyedIndex> leftFaces_;
  RadixSorter radixSorter_;
};

TopologicalSorter::TopologicalSorter(const SortInput& input)
    : input_(input),
      neighbors_(neighborsOf(*input.faces)),
      sides_(neighbors_.size()),
      marks_(neighbors_.size()),
      cells_(neighbors_.size()),
      search_(neighbors_) {
  boundary_.reserve(input.faces->boundaryCount);
  for (std::size_t cell = 0; cell < neighbors_.size(); ++cell)
    for (std::size_t i = 0; i < 4; ++i)
      if (neighbors_[cell][i] == kNoIndex)
        boundary_.push_back({input.faces->ofCell[cell][i], static_cast<Index>(cell)});
}

void TopologicalSorter::sortInPieces(const ViewPoint& view, FaceOrder& order,
                                     const std::function<void(std::size_t)>& ready) {
  order.faces.resize(input_.faces->size());
  if (!isSearched_ || view != view_ || askedPicture_) {
    view_ = view;
    askedPicture_ = false;
    const bool sidesChanged = findSides(), startsChanged = findStarts();
    view_.sideInPicture = {};  // may not outlive this call
    isSearched_ = isSearched_ && !sidesChanged && !startsChanged;
  }
  FacePieces pieces(cells_.size() / kCellsOfPiece + 1, input_.faces->ofCell, marks_, cells_, order.faces, ready);
  if (isSearched_) {
    for (const FacePieces::Piece& piece : pieces_) pieces.add(piece);
  } else {
    marks_ = sides_;
    search(pieces);
    isSearched_ = true;
  }
  pieces.finish();
  order.cycles = search_.cycles();
}

void TopologicalSorter::search(FacePieces& pieces) {
  pieces_.clear();
  search_.start(marks_, cells_,
                [this](Index cell, unsigned face) { return footprint(eyeHeightOf(input_.faces->ofCell[cell][face])); });
  const auto endPiece = [&] {
    const FacePieces::Piece last = pieces_.empty() ? FacePieces::Piece{} : pieces_.back();
    pieces_.push_back({last.endCell, search_.cellCount(), last.endFace, search_.faceCount()});
    pieces.add(pieces_.back());
  };
  for (const Index cell : starts_) search_.writeWithAllInFront(cell, kCellsOfPiece, endPiece);
  // What no ray leaves through a boundary: cells of cycles, or seen edge-on.
  for (std::size_t cell = 0; search_.cellCount() < cells_.size(); ++cell)
    search_.writeWithAllInFront(static_cast<Index>(cell), kCellsOfPiece, endPiece);
  if (pieces_.empty() || pieces_.back().endCell < cells_.size()) endPiece();
}

EyeHeight TopologicalSorter::eyeHeightOf(Index face) const {
  const auto& [a, b, c] = input_.faces->vertices[face];
  return eyeHeight(input_.points[a], input_.points[b], input_.points[c], view_);
}

Side TopologicalSorter::sideOf(Index face) const {
  const auto& [a, b, c] = input_.faces->vertices[face];
  const EyeHeight plane = eyeHeightOf(face);
  if (!view_.sideInPicture) return eyeSide(plane);
  const double edges = sizeOf(input_.points[b] - input_.points[a]) + sizeOf(input_.points[c] - input_.points[a]);
  const double reach = edges + reachOf(input_.points[a], plane.toEye, view_);
  if (std::abs(plane.height) > kPictureRounding * edges * reach * reach)
    return plane.height > 0 ? Side::outside : Side::inside;
  askedPicture_.store(true, std::memory_order_relaxed);
  return static_cast<Side>(view_.sideInPicture(input_.points[a], input_.points[b], input_.points[c]));
}

/// Which faces rays enter each cell through. Whether any of that is other than in the last view.
bool TopologicalSorter::findSides() {
  std::atomic<bool> changed = false;
  parallelBlocks(0, neighbors_.size(), kGrain, [&](std::size_t first, std::size_t last) {
    bool mine = false;
    for (std::size_t cell = first; cell < last; ++cell) {
      const CellMarks marks = marksOf(static_cast<Index>(cell));
      mine |= marks != sides_[cell];
      sides_[cell] = marks;
    }
    if (mine) changed.store(true, std::memory_order_relaxed);
  });
  return changed;
}

CellMarks TopologicalSorter::marksOf(Index cell) const {
  const CellHeights plane = cellHeights(input_.points, input_.tetrahedra[cell], view_);
  unsigned entered = 0, edgeOn = 0, inner = 0;
  for (unsigned i = 0; i < 4; ++i) {
    const Index other = neighbors_[cell][i];
    inner |= (other != kNoIndex ? 1u : 0u) << i;
    entered |= (plane.height[i] > 0 ? 1u : 0u) << i;
    if (std::abs(plane.height[i]) > plane.doubt) continue;
    const Side side = sideOf(input_.faces->ofCell[cell][i]);
    // The face is turned out of the cell with the lower number.
    const bool isEntered = side == (other > cell ? Side::outside : Side::inside);
    entered = (entered & ~(1u << i)) | ((isEntered ? 1u : 0u) << i);
    edgeOn |= (side == Side::edgeOn ? 1u : 0u) << i;
  }
  return {entered & inner, entered & ~inner, edgeOn & inner};
}

/// The cells with a boundary face that rays leave through, near ones first. "Near" is measured midway between the
/// face's centroid and its farthest vertex: on five real non-convex meshes from 24 views each that misorders no
/// fragment (the centroid: 3, the nearest vertex: 15), and on coarse grids with an unwelded seam as few as the centroid
/// does (the farthest vertex: eight times as many). Whether they are others than in the last view.
bool TopologicalSorter::findStarts() {
  const DistanceKey key(view_);
  constexpr std::uint32_t kNoStart = 0;  // of no number
  startKeys_.resize(boundary_.size());
  parallelFor(0, boundary_.size(), kGrain, [&](std::size_t i) {
    startKeys_[i] = kNoStart;
    if (sideOf(boundary_[i].face) != Side::inside) return;
    const auto& [a, b, c] = input_.faces->vertices[boundary_[i].face];
    const double farthest = std::max({key(input_.points[a]), key(input_.points[b]), key(input_.points[c])});
    const double middle = key((input_.points[a] + input_.points[b] + input_.points[c]) / 3.0);
    startKeys_[i] = sortableKey(static_cast<float>(0.5 * (middle + farthest)));
  });
  leftFaces_.clear();
  for (std::size_t i = 0; i < boundary_.size(); ++i)
    if (startKeys_[i] != kNoStart) leftFaces_.push_back({startKeys_[i], boundary_[i].cell});
  std::vector<Index> starts;
  radixSorter_.sort(leftFaces_, starts);
  const bool changed = starts != starts_;
  starts_ = std::move(starts);
  return changed;
}

}  // namespace

std::unique_ptr<FaceSorter> makeTopologicalSorter(const SortInput& input) {
  return std::make_unique<TopologicalSorter>(input);
}

}  // namespace havs
