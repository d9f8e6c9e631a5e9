#pragma once
// Cells in order become faces in order, piece by piece.
#include <tbb/task_group.h>

#include <array>
#include <atomic>
#include <functional>
#include <mutex>
#include <span>
#include <vector>

#include "sort/cell_search.h"

namespace havs {

/// Writes the faces of cells that are in order already while the search goes on: on other threads where there are any,
/// else at once. All that it is given must outlive it.
class FacePieces {
 public:
  /// A run of cells and the place of its first face.
  struct Piece {
    std::size_t firstCell, endCell, firstFace, endFace;
  };

  FacePieces(std::span<const std::array<Index, 4>> facesOfCell, std::span<const CellMarks> marks,
             std::span<const Index> cells, std::span<Index> faces, const std::function<void(std::size_t)>& ready);
  ~FacePieces();
  FacePieces(const FacePieces&) = delete;
  FacePieces& operator=(const FacePieces&) = delete;

  /// The cells of the piece are written. Pieces must come one behind the other.
  void add(const Piece& piece);
  /// Returns when all pieces are written; rethrows what `ready` threw.
  void finish();

 private:
  void write(const Piece& piece) const;
  void announce(std::size_t number, std::size_t endFace);

  std::span<const std::array<Index, 4>> facesOfCell_;
  std::span<const CellMarks> marks_;
  std::span<const Index> cells_;
  std::span<Index> faces_;
  const std::function<void(std::size_t)>& ready_;
  bool alone_;
  std::size_t pieces_ = 0;
  std::atomic<std::size_t> added_ = 0;
  std::mutex mutex_;
  std::vector<std::size_t> ends_;  ///< last face of each piece that is written, 0 of the others
  std::size_t announced_ = 0;
  tbb::task_group tasks_;
};

}  // namespace havs
