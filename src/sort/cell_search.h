#pragma once
// The search behind the topological order, in numbers of cells only. Separate so that what it touches stays small: of a
// cell 16 bytes that never change (its neighbours) and 2 that do (CellMarks).
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "mesh/tet_mesh.h"

namespace havs {

using Neighbors = std::array<Index, 4>;  ///< the cells behind the four faces; kNoIndex at the boundary

/// What a view says of one cell, and how far the search is with it. Bit i of each four stands for face i.
class CellMarks {
 public:
  CellMarks() = default;
  /// `inFront`: rays come through the face from the cell behind it. `entered`: they enter the mesh there. `open`: to a
  /// cell of which it is not known whether it is in front or behind.
  CellMarks(unsigned inFront, unsigned entered, unsigned open)
      : bits_(static_cast<std::uint16_t>(inFront | (entered << 4) | (open << 8))) {}

  bool operator==(const CellMarks&) const = default;
  unsigned inFront() const { return bits_ & 15u; }
  unsigned entered() const { return (bits_ >> 4) & 15u; }
  unsigned open() const { return (bits_ >> 8) & 15u; }
  bool isFresh() const { return (bits_ & (kOnStack | kWritten)) == 0; }
  bool isOnStack() const { return (bits_ & kOnStack) != 0; }
  bool isWritten() const { return (bits_ & kWritten) != 0; }
  /// Of a written cell: the faces that go out with it, those rays enter the mesh through first.
  unsigned facesFirst() const { return bits_ & entered(); }
  unsigned facesThen() const { return bits_ & 15u & ~entered(); }
  unsigned faceCount() const { return static_cast<unsigned>(std::popcount(bits_ & 15u)); }

  void putOnStack() { bits_ = static_cast<std::uint16_t>(bits_ | kOnStack); }
  void takeFromStack() { bits_ = static_cast<std::uint16_t>(bits_ & ~kOnStack); }
  /// Ignores that a cell is in front. It goes out before the others of its cell, as a face that rays enter through.
  void cut(unsigned face) {
    const unsigned bit = 1u << face;
    bits_ = static_cast<std::uint16_t>((bits_ & ~bit) | (bit << 4) | (bit << 8));
  }
  void setOpen(unsigned face) { bits_ = static_cast<std::uint16_t>(bits_ | (1u << (face + 8))); }
  void write(unsigned faces) { bits_ = static_cast<std::uint16_t>((bits_ & 0xF0u) | faces | kWritten); }

 private:
  static constexpr unsigned kOnStack = 1u << 12, kWritten = 1u << 13;
  std::uint16_t bits_ = 0;
};

/// Depth-first search over cells by which is in front of which.
class CellSearch {
 public:
  /// How much of the picture the face between a cell and the one in front takes.
  using Footprint = std::function<double(Index cell, unsigned face)>;

  /// `neighbors` must outlive it, as must what start() is given.
  explicit CellSearch(std::span<const Neighbors> neighbors) : neighbors_(neighbors) {}

  /// A new search: no cell is written. `cells` has room for all.
  void start(std::span<CellMarks> marks, std::span<Index> cells, Footprint footprint);
  /// Writes `start` to cells, after all cells in front of it that are not written; nothing if it is written already.
  /// `piece()` is called after each `cellsOfPiece` cells.
  template <class Piece>
  void writeWithAllInFront(Index start, std::size_t cellsOfPiece, const Piece& piece);

  std::size_t cellCount() const { return cellCount_; }  ///< written
  std::size_t faceCount() const { return faceCount_; }  ///< that go out with them
  std::size_t cycles() const { return cycles_; }        ///< cut

 private:
  struct Step {
    Index cell;
    std::uint8_t left;  ///< faces still to be followed
    std::uint8_t face;  ///< followed last
  };

  unsigned facesOf(Index cell) const;
  unsigned closedFaces(Index cell, unsigned faces) const;
  void fetchNeighbors(Index cell) const;
  void cutCycle(Index repeated);

  std::span<const Neighbors> neighbors_;
  std::span<CellMarks> marks_;
  std::span<Index> cells_;
  Footprint footprint_;
  std::vector<Step> stack_;
  std::size_t cellCount_ = 0, faceCount_ = 0, cycles_ = 0;
};

/// The faces that go out with a cell, now. A face to a cell in front went out with that; of an open face the cell that
/// is written first takes it.
inline unsigned CellSearch::facesOf(Index cell) const {
  const CellMarks marks = marks_[cell];
  const unsigned faces = 15u & ~marks.inFront();
  return marks.open() == 0 ? faces : closedFaces(cell, faces);
}

template <class Piece>
void CellSearch::writeWithAllInFront(Index start, std::size_t cellsOfPiece, const Piece& piece) {
  if (!marks_[start].isFresh()) return;
  Index cell = start;  // with its faces that are still to be followed; those behind it wait on the stack
  marks_[cell].putOnStack();
  unsigned left = marks_[cell].inFront();
  stack_.clear();
  for (;;) {
    if (left == 0) {
      const unsigned faces = facesOf(cell);
      marks_[cell].write(faces);
      faceCount_ += static_cast<std::size_t>(std::popcount(faces));
      cells_[cellCount_++] = cell;
      if (cellCount_ % cellsOfPiece == 0) piece();
      if (stack_.empty()) return;
      cell = stack_.back().cell;
      left = stack_.back().left;
      stack_.pop_back();
      continue;
    }
    const auto face = static_cast<unsigned>(std::countr_zero(left));
    left &= left - 1;
    const Index other = neighbors_[cell][face];
    CellMarks& marks = marks_[other];
    if (marks.isWritten()) continue;
    stack_.push_back({cell, static_cast<std::uint8_t>(left), static_cast<std::uint8_t>(face)});
    if (marks.isOnStack()) {
      cutCycle(other);
      cell = stack_.back().cell;
      left = stack_.back().left;
      stack_.pop_back();
      continue;
    }
    marks.putOnStack();
    cell = other;
    left = marks.inFront();
    fetchNeighbors(cell);
  }
}

/// What the search will look at next depends on what it finds now: a third of its time went by in waiting.
inline void CellSearch::fetchNeighbors(Index cell) const {
  for (const Index neighbor : neighbors_[cell]) {
    const Index near = neighbor == kNoIndex ? cell : neighbor;
    __builtin_prefetch(&neighbors_[near]);
    __builtin_prefetch(&marks_[near]);
  }
}

}  // namespace havs
