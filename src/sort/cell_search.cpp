#include "sort/cell_search.h"

#include <limits>
#include <utility>

namespace havs {
namespace {

/// Relations of a cycle that are looked at for the one to cut: keeps the search linear.
constexpr std::size_t kCutReach = 256;

}  // namespace

void CellSearch::start(std::span<CellMarks> marks, std::span<Index> cells, Footprint footprint) {
  marks_ = marks;
  cells_ = cells;
  footprint_ = std::move(footprint);
  stack_.clear();
  cellCount_ = faceCount_ = cycles_ = 0;
}

unsigned CellSearch::closedFaces(Index cell, unsigned faces) const {
  for (unsigned i = 0; i < 4; ++i)
    if (((marks_[cell].open() >> i) & 1u) != 0 && marks_[neighbors_[cell][i]].isWritten()) faces &= ~(1u << i);
  return faces;
}

/// The cells of the stack from `repeated` to the top are each behind the next, and the last is behind `repeated`. Cuts
/// the relation across the face with the smallest footprint; the cells beyond it leave the stack and will be reached
/// again.
void CellSearch::cutCycle(Index repeated) {
  ++cycles_;
  std::size_t weakest = stack_.size() - 1;
  double smallest = std::numeric_limits<double>::infinity();
  for (std::size_t place = stack_.size(), reach = kCutReach; place-- > 0 && reach > 0; --reach) {
    const Step& step = stack_[place];
    const double area = footprint_(step.cell, step.face);
    if (area < smallest) {
      smallest = area;
      weakest = place;
    }
    if (step.cell == repeated) break;
  }
  const Step& cut = stack_[weakest];
  marks_[cut.cell].cut(cut.face);
  const Index inFront = neighbors_[cut.cell][cut.face];
  for (unsigned i = 0; i < 4; ++i)
    if (neighbors_[inFront][i] == cut.cell) marks_[inFront].setOpen(i);
  for (std::size_t place = weakest + 1; place < stack_.size(); ++place) marks_[stack_[place].cell].takeFromStack();
  stack_.resize(weakest + 1);
}

}  // namespace havs
