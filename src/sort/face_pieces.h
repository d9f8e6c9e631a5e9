#pragma once
// Cells in order become faces in order, piece by piece.
#include <array>
#include <functional>
#include <mutex>
#include <span>
#include <vector>

#include "core/parallel.h"
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

  /// `most`: pieces at the most.
  FacePieces(std::size_t most, std::span<const std::array<Index, 4>> facesOfCell, std::span<const CellMarks> marks,
             std::span<const Index> cells, std::span<Index> faces, const std::function<void(std::size_t)>& ready);
  /// The cells of the piece are written. Pieces must come one behind the other.
  void add(const Piece& piece);
  /// Returns when all pieces are written; rethrows what `ready` threw.
  void finish();

 private:
  void write(const Piece& piece) const;
  void announce(std::size_t number);

  std::span<const std::array<Index, 4>> facesOfCell_;
  std::span<const CellMarks> marks_;
  std::span<const Index> cells_;
  std::span<Index> faces_;
  const std::function<void(std::size_t)>& ready_;
  bool alone_;
  std::vector<Piece> pieces_;  ///< never moves, as other threads read of it
  std::mutex mutex_;
  std::vector<char> isWritten_;  ///< one a piece
  std::size_t announced_ = 0;    ///< pieces
  bool isAnnouncing_ = false;
  Tasks tasks_;
};

}  // namespace havs
