#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "mesh/faces.h"
#include "render/native/tile_draw.h"

namespace havs {

/// The tiles of a picture, all of one size but for those at its right and lower edge.
struct TileGrid {
  int side = 64;  ///< pixels, a multiple of kStampSide
  int across = 0, down = 0;
  std::size_t count() const { return static_cast<std::size_t>(across) * static_cast<std::size_t>(down); }
};
TileGrid tileGrid(int width, int height, int side);

/// Which faces each tile draws, near first: a counting sort of (tile, face) pairs, in parallel, that keeps the order.
class FaceBins {
 public:
  /// Finds the tiles that each face may cover: those with a pixel centre in its bounding box.
  void findTiles(const RasterMesh& mesh, std::size_t pointCount, const Faces& faces, const TileGrid& grid);

  /// The same of cells, RasterMesh::cells, in place of faces.
  void findTilesOfCells(const RasterMesh& mesh, std::size_t pointCount, std::size_t cellCount, const TileGrid& grid);

  /// Counts the pairs for `order`, which must stay as it is until the last list is filled.
  void count(std::span<const Index> order);
  /// Fills the lists of tiles from `firstTile` on, as many as fit into `mostPairs` pairs, one at least; returns the
  /// first that is not filled.
  std::size_t fill(std::size_t firstTile, std::size_t mostPairs);
  /// Of a tile that the last call of fill has filled. Faces on the boundary have kBoundaryBit.
  std::span<const std::uint32_t> facesOf(std::size_t tile) const;
  std::size_t pairs() const { return pairs_; }

 private:
  struct TileBox {
    std::uint16_t left, top, right;  ///< both ends included; left > right: none
    std::uint16_t bottom : 15;
    std::uint16_t boundary : 1;  ///< the face is on the mesh's; here, so that lists need to look at nothing else
  };
  /// Of a point: the first and last pixels that a box which ends there may cover.
  struct PixelBox {
    std::int32_t left, top, right, bottom;
  };
  void placePoints(const RasterMesh& mesh, std::size_t pointCount, const TileGrid& grid);
  template <std::size_t kCorners>
  void findBoxes(const std::uint32_t (*corners)[kCorners], std::size_t count);
  template <class Visit>
  void visitTiles(Index face, std::size_t firstTile, std::size_t lastTile, const Visit& visit) const;

  TileGrid grid_;
  std::vector<PixelBox> pixels_;  ///< of the points
  std::vector<TileBox> boxes_;    ///< of the faces
  std::span<const Index> order_;
  std::size_t blocks_ = 0;             ///< of the order, each binned by one thread
  std::vector<std::uint32_t> counts_;  ///< of each block and tile: block * tiles + tile
  std::vector<std::size_t> ofTile_;    ///< pairs of each tile
  std::size_t pairs_ = 0;
  std::size_t firstTile_ = 0, lastTile_ = 0;  ///< that are filled
  std::vector<std::size_t> begins_;           ///< of the filled tiles' lists, and the end
  std::vector<std::uint32_t> lists_;
};

}  // namespace havs
