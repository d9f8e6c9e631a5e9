#include "sort/face_pieces.h"

#include <algorithm>
#include <array>
#include <cstdint>

#include "core/parallel.h"

namespace havs {
namespace {

/// The faces that go out with a cell, in their order.
struct CellFaces {
  std::array<std::uint8_t, 4> place;
  std::uint8_t count;
};

/// By which go first (four bits) and which then (four bits).
constexpr std::array<CellFaces, 256> kCellFaces = [] {
  std::array<CellFaces, 256> all{};
  for (unsigned bits = 0; bits < 256; ++bits)
    for (const unsigned half : {bits >> 4, bits & 15u})
      for (std::uint8_t i = 0; i < 4; ++i)
        if (((half >> i) & 1u) != 0 && all[bits].count < 4) all[bits].place[all[bits].count++] = i;
  return all;
}();

}  // namespace

FacePieces::FacePieces(std::size_t most, std::span<const std::array<Index, 4>> facesOfCell,
                       std::span<const CellMarks> marks, std::span<const Index> cells, std::span<Index> faces,
                       const std::function<void(std::size_t)>& ready)
    : facesOfCell_(facesOfCell),
      marks_(marks),
      cells_(cells),
      faces_(faces),
      ready_(ready),
      alone_(threadCount() == 1),
      isWritten_(most, 0),
      tasks_([this](std::size_t number) {
        write(pieces_[number]);
        announce(number);
      }) {
  pieces_.reserve(most);
}

void FacePieces::add(const Piece& piece) {
  pieces_.push_back(piece);
  if (alone_) {
    write(piece);
    announce(pieces_.size() - 1);
  } else {
    tasks_.add(pieces_.size() - 1);
  }
}

void FacePieces::finish() { tasks_.wait(); }

void FacePieces::write(const Piece& piece) const {
  Index* face = faces_.data() + piece.firstFace;
  const auto facesOf = [&](std::size_t place) -> const CellFaces& {
    const CellMarks marks = marks_[cells_[place]];
    return kCellFaces[marks.facesFirst() << 4 | marks.facesThen()];
  };
  std::size_t place = piece.firstCell;
  // All four places are written, used or not, as long as they do not reach into the next piece.
  for (; place < piece.endCell && face + 4 <= faces_.data() + piece.endFace; ++place) {
    const CellFaces& which = facesOf(place);
    const auto& faces = facesOfCell_[cells_[place]];
    for (std::size_t i = 0; i < 4; ++i) face[i] = faces[which.place[i]];
    face += which.count;
  }
  for (; place < piece.endCell; ++place) {
    const CellFaces& which = facesOf(place);
    for (std::size_t i = 0; i < which.count; ++i) *face++ = facesOfCell_[cells_[place]][which.place[i]];
  }
}

/// One thread at a time announces, without the lock: what `ready` does may lead it here again.
void FacePieces::announce(std::size_t number) {
  std::unique_lock lock(mutex_);
  isWritten_[number] = 1;
  if (isAnnouncing_) return;
  isAnnouncing_ = true;
  for (;;) {
    const std::size_t before = announced_;
    while (announced_ < isWritten_.size() && isWritten_[announced_] != 0) ++announced_;
    if (announced_ == before) break;
    const std::size_t ready = pieces_[announced_ - 1].endFace;
    lock.unlock();
    if (ready_) ready_(ready);
    lock.lock();
  }
  isAnnouncing_ = false;
}

}  // namespace havs
