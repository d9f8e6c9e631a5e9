// The order by depth-first search (Williams 1992, "Visibility ordering meshed polyhedra", its MPVO order; here by
// post-order, near first). The plane of a face between two cells tells which of them is in front: the one on the eye's
// side. Follow that relation from a cell to the cells in front of it, and write each cell when all of these are
// written: no cell then comes before one that hides part of it. Every ray leaves the mesh somewhere, so the search
// starts at cells with a boundary face that rays leave through, near ones first: what a nearer part of a non-convex
// mesh consists of is written before the search reaches a part behind it. Where cells hide each other in a cycle, the
// relation across the face that shows smallest is ignored, and counted: every ray that does not pass that face still
// meets all cells in order.
#include <algorithm>
#include <cmath>
#include <limits>

#include "core/parallel.h"
#include "sort/distance_key.h"
#include "sort/radix_sort.h"
#include "sort/sorters.h"
#include "sort/spatial_order.h"

namespace havs {
namespace {

constexpr std::size_t kGrain = 8192;
/// Relations of a cycle that are looked at for the one to cut: keeps the search linear.
constexpr std::size_t kCutReach = 256;

/// On which side of a face, as oriented by Faces, the eye is.
enum class Side : std::int8_t { inside = -1, edgeOn = 0, outside = 1 };

/// The face's plane at the eye: `height` is six times the volume of face and eye, positive outside.
struct EyeHeight {
  double height;
  double bound;  ///< of the rounding error
  Vec3 toEye;
};

EyeHeight eyeHeight(const Vec3& a, const Vec3& b, const Vec3& c, const ViewPoint& view) {
  const Vec3 ab = b - a, ac = c - a;
  const Vec3 toEye = view.orthographic ? -view.direction : view.eye - a;
  constexpr double kRounding = 8 * std::numeric_limits<double>::epsilon();  // of three products and their sums
  return {dot(cross(ab, ac), toEye), kRounding * std::sqrt(dot(ab, ab) * dot(ac, ac) * dot(toEye, toEye)), toEye};
}

/// Outside: a ray through the face passes from cells[1] to cells[0]. Edge-on also where rounding hides the sign: no
/// pixel can tell the difference.
Side eyeSide(const EyeHeight& plane) {
  if (std::abs(plane.height) <= plane.bound) return Side::edgeOn;
  return plane.height > 0 ? Side::outside : Side::inside;
}

/// Grows with the area that the face takes of the picture.
double footprint(const EyeHeight& plane) {
  const double distance = length(plane.toEye);  // 1 for orthographic
  return std::abs(plane.height) / (distance * distance * distance);
}

/// Cells are numbered here along a curve through space, so that the search finds neighbours near in memory.
class TopologicalSorter final : public FaceSorter {
 public:
  explicit TopologicalSorter(const SortInput& input);
  void sort(const ViewPoint& view, FaceOrder& order) override;

 private:
  enum class State : std::uint8_t { fresh, open, written };
  struct BoundaryFace {
    Index face, cell;
  };

  EyeHeight eyeHeightOf(Index face) const;
  void findSides();
  void findEnteredFaces();
  void findStarts();
  void writeWithAllInFront(Index start, FaceOrder& order);
  void cutCycle(Index repeated);
  void writeFaces(Index cell, std::vector<Index>& faces);

  SortInput input_;
  ViewPoint view_;
  std::vector<std::array<Index, 4>> cellFaces_;  ///< the faces of each cell
  std::vector<std::array<Index, 4>> neighbors_;  ///< the cells behind them, kNoIndex at the boundary
  std::vector<std::uint8_t> outward_;            ///< one a cell: bit i where the normal of its face i points out of it
  std::vector<BoundaryFace> boundary_;
  std::vector<Side> sides_;  ///< of the eye, one a face
  std::vector<std::uint8_t>
      entered_;  ///< one a cell: bit i where rays enter through face i, bit 4 + i where that relation is cut
  std::vector<State> states_;         ///< one a cell
  std::vector<std::uint32_t> stack_;  ///< 8 * cell + the next of its faces to follow
  std::vector<KeyedIndex> leftFaces_;
  std::vector<Index> starts_;
  RadixSorter radixSorter_;
};

TopologicalSorter::TopologicalSorter(const SortInput& input) : input_(input) {
  const Faces& faces = *input.faces;
  const std::vector<Index> cellAt = spatialOrder(input.points, input.tetrahedra);
  std::vector<Index> placeOf(cellAt.size());
  parallelFor(0, cellAt.size(), kGrain, [&](std::size_t place) { placeOf[cellAt[place]] = static_cast<Index>(place); });
  cellFaces_.resize(cellAt.size());
  neighbors_.resize(cellAt.size());
  outward_.resize(cellAt.size());
  parallelFor(0, cellAt.size(), kGrain, [&](std::size_t place) {
    cellFaces_[place] = faces.ofCell[cellAt[place]];
    unsigned outward = 0;
    for (unsigned i = 0; i < 4; ++i) {
      const auto& [first, second] = faces.cells[cellFaces_[place][i]];
      const bool isFirst = first == cellAt[place];
      const Index other = isFirst ? second : first;
      neighbors_[place][i] = other == kNoIndex ? kNoIndex : placeOf[other];
      outward |= (isFirst ? 1u : 0u) << i;
    }
    outward_[place] = static_cast<std::uint8_t>(outward);
  });
  boundary_.reserve(faces.boundaryCount);
  for (std::size_t cell = 0; cell < neighbors_.size(); ++cell)
    for (std::size_t i = 0; i < 4; ++i)
      if (neighbors_[cell][i] == kNoIndex) boundary_.push_back({cellFaces_[cell][i], static_cast<Index>(cell)});
}

void TopologicalSorter::sort(const ViewPoint& view, FaceOrder& order) {
  view_ = view;
  findSides();
  findEnteredFaces();
  findStarts();
  states_.assign(neighbors_.size(), State::fresh);
  order.cycles = 0;
  order.faces.clear();
  order.faces.reserve(input_.faces->size());
  for (const Index cell : starts_) writeWithAllInFront(cell, order);
  // What no ray leaves through a boundary: cells of cycles, or seen edge-on.
  for (std::size_t cell = 0; cell < neighbors_.size(); ++cell) writeWithAllInFront(static_cast<Index>(cell), order);
}

EyeHeight TopologicalSorter::eyeHeightOf(Index face) const {
  const auto& [a, b, c] = input_.faces->vertices[face];
  return eyeHeight(input_.points[a], input_.points[b], input_.points[c], view_);
}

void TopologicalSorter::findSides() {
  sides_.resize(input_.faces->size());
  parallelFor(0, sides_.size(), kGrain,
              [&](std::size_t f) { sides_[f] = eyeSide(eyeHeightOf(static_cast<Index>(f))); });
}

void TopologicalSorter::findEnteredFaces() {
  entered_.resize(cellFaces_.size());
  parallelFor(0, cellFaces_.size(), kGrain, [&](std::size_t cell) {
    unsigned entered = 0;
    for (unsigned i = 0; i < 4; ++i) {
      const bool outward = ((outward_[cell] >> i) & 1u) != 0;
      entered |= (sides_[cellFaces_[cell][i]] == (outward ? Side::outside : Side::inside) ? 1u : 0u) << i;
    }
    entered_[cell] = static_cast<std::uint8_t>(entered);
  });
}

/// The cells with a boundary face that rays leave through, near ones first. "Near" is measured midway between the
/// face's centroid and its farthest vertex: on five real non-convex meshes from 24 views each that misorders no
/// fragment (the centroid: 3, the nearest vertex: 15), and on coarse grids with an unwelded seam as few as the centroid
/// does (the farthest vertex: eight times as many).
void TopologicalSorter::findStarts() {
  const DistanceKey key(view_);
  leftFaces_.clear();
  for (const BoundaryFace& boundary : boundary_) {
    if (sides_[boundary.face] != Side::inside) continue;
    const auto& [a, b, c] = input_.faces->vertices[boundary.face];
    const double farthest = std::max({key(input_.points[a]), key(input_.points[b]), key(input_.points[c])});
    const double middle = key((input_.points[a] + input_.points[b] + input_.points[c]) / 3.0);
    leftFaces_.push_back({sortableKey(static_cast<float>(0.5 * (middle + farthest))), boundary.cell});
  }
  radixSorter_.sort(leftFaces_, starts_);
}

/// Writes the cell `start` after all cells in front of it; nothing if it is written already.
void TopologicalSorter::writeWithAllInFront(Index start, FaceOrder& order) {
  if (states_[start] != State::fresh) return;
  states_[start] = State::open;
  stack_.assign(1, 8 * start);
  while (!stack_.empty()) {
    const Index cell = stack_.back() / 8;
    const std::size_t next = stack_.back() % 8;
    if (next == 4) {
      stack_.pop_back();
      states_[cell] = State::written;
      writeFaces(cell, order.faces);
      continue;
    }
    ++stack_.back();
    const Index inFront = neighbors_[cell][next];
    if (((entered_[cell] >> next) & 0x11u) != 1u || inFront == kNoIndex) continue;  // not entered there, or cut
    if (states_[inFront] == State::fresh) {
      states_[inFront] = State::open;
      stack_.push_back(8 * inFront);
    } else if (states_[inFront] == State::open) {
      ++order.cycles;
      cutCycle(inFront);
    }
  }
}

/// The cells of the stack from `repeated` to the top are each behind the next, and the last is behind `repeated`. Cuts
/// the relation across the face with the smallest footprint; the cells beyond it leave the stack and will be reached
/// again.
void TopologicalSorter::cutCycle(Index repeated) {
  auto followedFace = [&](std::size_t place) { return stack_[place] % 8 - 1; };
  std::size_t weakest = stack_.size() - 1;
  double smallest = std::numeric_limits<double>::infinity();
  for (std::size_t place = stack_.size(), reach = kCutReach; place-- > 0 && reach > 0; --reach) {
    const Index cell = stack_[place] / 8;
    const double area = footprint(eyeHeightOf(cellFaces_[cell][followedFace(place)]));
    if (area < smallest) {
      smallest = area;
      weakest = place;
    }
    if (cell == repeated) break;
  }
  const std::uint32_t cut = 0x10u << followedFace(weakest);
  entered_[stack_[weakest] / 8] = static_cast<std::uint8_t>(entered_[stack_[weakest] / 8] | cut);
  for (std::size_t place = weakest + 1; place < stack_.size(); ++place) states_[stack_[place] / 8] = State::fresh;
  stack_.resize(weakest + 1);
}

/// First the faces that rays enter the cell through, then the others: those they leave it through, and those seen
/// edge-on. A face to a cell that is written is written with it.
void TopologicalSorter::writeFaces(Index cell, std::vector<Index>& faces) {
  for (const unsigned entered : {1u, 0u})
    for (unsigned i = 0; i < 4; ++i) {
      const Index other = neighbors_[cell][i];
      const bool isWritten = other != kNoIndex && states_[other] == State::written;
      if (((entered_[cell] >> i) & 1u) == entered && !isWritten) faces.push_back(cellFaces_[cell][i]);
    }
}

}  // namespace

std::unique_ptr<FaceSorter> makeTopologicalSorter(const SortInput& input) {
  return std::make_unique<TopologicalSorter>(input);
}

}  // namespace havs
