#include "sort/face_pieces.h"

#include <bit>

#include "core/parallel.h"

namespace havs {

FacePieces::FacePieces(std::span<const std::array<Index, 4>> facesOfCell, std::span<const CellMarks> marks,
                       std::span<const Index> cells, std::span<Index> faces,
                       const std::function<void(std::size_t)>& ready)
    : facesOfCell_(facesOfCell),
      marks_(marks),
      cells_(cells),
      faces_(faces),
      ready_(ready),
      alone_(threadCount() == 1) {}

FacePieces::~FacePieces() {
  tasks_.cancel();  // there are none left unless something was thrown
  try {
    tasks_.wait();
  } catch (...) {
  }
}

void FacePieces::add(const Piece& piece) {
  const std::size_t number = pieces_++;
  if (alone_) {
    write(piece);
    if (ready_) ready_(piece.endFace);
    return;
  }
  added_.store(pieces_, std::memory_order_release);
  tasks_.run([this, piece, number] {
    added_.load(std::memory_order_acquire);  // what the search wrote for this piece
    write(piece);
    announce(number, piece.endFace);
  });
}

void FacePieces::finish() {
  tasks_.wait();
  const std::lock_guard lock(mutex_);  // what the tasks wrote
}

void FacePieces::write(const Piece& piece) const {
  Index* face = faces_.data() + piece.firstFace;
  for (std::size_t place = piece.firstCell; place < piece.endCell; ++place) {
    const Index cell = cells_[place];
    const auto& faces = facesOfCell_[cell];
    const CellMarks marks = marks_[cell];
    for (unsigned left = marks.facesFirst(); left != 0; left &= left - 1)
      *face++ = faces[static_cast<unsigned>(std::countr_zero(left))];
    for (unsigned left = marks.facesThen(); left != 0; left &= left - 1)
      *face++ = faces[static_cast<unsigned>(std::countr_zero(left))];
  }
}

void FacePieces::announce(std::size_t number, std::size_t endFace) {
  const std::lock_guard lock(mutex_);
  if (ends_.size() <= number) ends_.resize(number + 1, 0);
  ends_[number] = endFace;
  const std::size_t before = announced_;
  while (announced_ < ends_.size() && ends_[announced_] != 0) ++announced_;
  if (announced_ > before && ready_) ready_(ends_[announced_ - 1]);
}

}  // namespace havs
