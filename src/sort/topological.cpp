// The order by depth-first search (Williams 1992, "Visibility ordering meshed polyhedra", its MPVO order; here by post-order, near first).
// The plane of a face between two cells tells which of them is in front: the one on the eye's side. Follow that relation from a cell to
// the cells in front of it, and write each cell when all of these are written: no cell then comes before one that hides part of
// it. Every ray leaves the mesh somewhere, so the search starts at cells with a boundary face that rays leave through, near ones
// first: what a nearer part of a non-convex mesh consists of is written before the search reaches a part behind it.
// Where cells hide each other in a cycle, the relation across the face that shows smallest is ignored, and counted: every ray
// that does not pass that face still meets all cells in order.
#include <algorithm>
#include <cmath>
#include <limits>

#include "core/parallel.h"
#include "sort/distance_key.h"
#include "sort/radix_sort.h"
#include "sort/sorters.h"

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

class TopologicalSorter final : public FaceSorter {
 public:
  explicit TopologicalSorter(const SortInput& input);
  void sort(const ViewPoint& view, FaceOrder& order) override;

 private:
  enum class State : std::uint8_t { fresh, open, written };

  void findSides();
  void findEnteredFaces();
  void findStarts();
  EyeHeight eyeHeightOf(Index face) const;
  void writeWithAllInFront(Index start, FaceOrder& order);
  void cutCycle(Index repeated);
  void writeFaces(Index cell, std::vector<Index>& faces);

  SortInput input_;
  ViewPoint view_;
  std::vector<std::array<Index, 4>> neighbors_;  ///< the cell behind face i of a cell, kNoIndex at the boundary
  std::vector<Index> boundaryFaces_;
  std::vector<Side> sides_;             ///< of the eye, one a face
  std::vector<std::uint8_t> entered_;   ///< one a cell: bit i where rays enter the cell through its face i, bit 4 + i where a cut hides that
  std::vector<State> states_;           ///< one a cell
  std::vector<std::uint8_t> isWritten_; ///< one a face
  std::vector<std::uint32_t> stack_;    ///< 8 * cell + the next of its faces to follow
  std::vector<KeyedIndex> leftFaces_;
  std::vector<Index> starts_;
  RadixSorter radixSorter_;
};

TopologicalSorter::TopologicalSorter(const SortInput& input) : input_(input) {
  const Faces& faces = *input.faces;
  neighbors_.resize(faces.ofCell.size());
  parallelFor(0, neighbors_.size(), kGrain, [&](std::size_t c) {
    for (std::size_t i = 0; i < 4; ++i) {
      const auto& [first, second] = faces.cells[faces.ofCell[c][i]];
      neighbors_[c][i] = first == c ? second : first;
    }
  });
  boundaryFaces_.reserve(faces.boundaryCount);
  for (std::size_t f = 0; f < faces.size(); ++f)
    if (faces.isBoundary(f)) boundaryFaces_.push_back(static_cast<Index>(f));
}

void TopologicalSorter::sort(const ViewPoint& view, FaceOrder& order) {
  const std::size_t cellCount = neighbors_.size();
  view_ = view;
  findSides();
  findEnteredFaces();
  findStarts();
  states_.assign(cellCount, State::fresh);
  isWritten_.assign(input_.faces->size(), 0);
  order.cycles = 0;
  order.faces.clear();
  order.faces.reserve(input_.faces->size());
  for (const Index face : starts_) writeWithAllInFront(input_.faces->cells[face][0], order);
  // What no ray leaves through a boundary: cells of cycles, or seen edge-on.
  for (std::size_t c = 0; c < cellCount; ++c) writeWithAllInFront(static_cast<Index>(c), order);
}

EyeHeight TopologicalSorter::eyeHeightOf(Index face) const {
  const auto& [a, b, c] = input_.faces->vertices[face];
  return eyeHeight(input_.points[a], input_.points[b], input_.points[c], view_);
}

void TopologicalSorter::findSides() {
  sides_.resize(input_.faces->size());
  parallelFor(0, sides_.size(), kGrain, [&](std::size_t f) { sides_[f] = eyeSide(eyeHeightOf(static_cast<Index>(f))); });
}

void TopologicalSorter::findEnteredFaces() {
  const Faces& faces = *input_.faces;
  entered_.resize(neighbors_.size());
  parallelFor(0, neighbors_.size(), kGrain, [&](std::size_t c) {
    unsigned bits = 0;
    for (unsigned i = 0; i < 4; ++i) {
      const Index face = faces.ofCell[c][i];
      const Side enteredFrom = faces.cells[face][0] == c ? Side::outside : Side::inside;
      bits |= (sides_[face] == enteredFrom ? 1u : 0u) << i;
    }
    entered_[c] = static_cast<std::uint8_t>(bits);
  });
}

/// The boundary faces that rays leave through, near ones first.
void TopologicalSorter::findStarts() {
  const DistanceKey key(view_);
  leftFaces_.clear();
  for (const Index face : boundaryFaces_) {
    if (sides_[face] != Side::inside) continue;
    const auto& [a, b, c] = input_.faces->vertices[face];
    const Vec3 centroid = (input_.points[a] + input_.points[b] + input_.points[c]) / 3.0;
    leftFaces_.push_back({sortableKey(static_cast<float>(key(centroid))), face});
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

/// The cells of the stack from `repeated` to the top are each behind the next, and the last is behind `repeated`. Cuts the
/// relation across the face with the smallest footprint; the cells beyond it leave the stack and will be reached again.
void TopologicalSorter::cutCycle(Index repeated) {
  auto followedFace = [&](std::size_t place) { return stack_[place] % 8 - 1; };
  std::size_t weakest = stack_.size() - 1;
  double smallest = std::numeric_limits<double>::infinity();
  for (std::size_t place = stack_.size(), reach = kCutReach; place-- > 0 && reach > 0; --reach) {
    const Index cell = stack_[place] / 8;
    const double area = footprint(eyeHeightOf(input_.faces->ofCell[cell][followedFace(place)]));
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

/// First the faces that rays enter the cell through, then the others: those they leave it through, and those seen edge-on.
void TopologicalSorter::writeFaces(Index cell, std::vector<Index>& faces) {
  const auto& facesOfCell = input_.faces->ofCell[cell];
  for (const unsigned entered : {1u, 0u})
    for (unsigned i = 0; i < 4; ++i) {
      const Index face = facesOfCell[i];
      if (((entered_[cell] >> i) & 1u) != entered || isWritten_[face] != 0) continue;
      isWritten_[face] = 1;
      faces.push_back(face);
    }
}

}  // namespace

std::unique_ptr<FaceSorter> makeTopologicalSorter(const SortInput& input) {
  return std::make_unique<TopologicalSorter>(input);
}

}  // namespace havs
