#pragma once
// Exact fragments of faces at pixel centres, tile by tile.
#include <cstdint>
#include <span>
#include <vector>

#include "mesh/faces.h"
#include "scene/view.h"

namespace havs::test {

inline constexpr int kTileSize = 16;

struct ExactFragment {
  double scalar;
  double distance;  ///< along the ray from the plane through the mesh's centre
  int kind;         ///< +1 entry, -1 exit, 0 between two cells
};

/// All faces projected and binned to the tiles they touch, in their order. The scene must outlive it.
class FragmentSource {
 public:
  /// A place in the picture in units of 2^-26 pixel, x right, y down.
  struct SubPixel {
    std::int64_t x, y;
    bool operator==(const SubPixel&) const = default;
  };

  /// Throws std::invalid_argument for points behind the eye.
  FragmentSource(std::span<const Vec3> points, const Faces& faces, std::span<const Index> order,
                 std::span<const double> scalars, const View& view);

  std::size_t tileCount() const { return static_cast<std::size_t>(tilesX_) * static_cast<std::size_t>(tilesY_); }
  /// Pixel column and row of the tile's first pixel.
  int firstColumn(std::size_t tile) const {
    return static_cast<int>(tile % static_cast<std::size_t>(tilesX_)) * kTileSize;
  }
  int firstRow(std::size_t tile) const {
    return static_cast<int>(tile / static_cast<std::size_t>(tilesX_)) * kTileSize;
  }
  /// The fragments of each pixel of the tile, kTileSize pixels a row, in the order of the faces.
  void collect(std::size_t tile, std::vector<std::vector<ExactFragment>>& pixels) const;

 private:
  struct PixelBox {
    int left, top, right, bottom;  ///< inclusive; empty where right < left
  };
  PixelBox boxOf(Index face) const;
  void binFaces(std::span<const Index> order);
  void collectFace(Index face, std::size_t tile, std::vector<std::vector<ExactFragment>>& pixels) const;

  const Faces& faces_;
  std::span<const double> scalars_;
  const View& view_;
  std::vector<SubPixel> pixels_;
  std::vector<double> nearness_;  ///< 1 / distance along forward from the eye; orthographic: 1
  std::vector<double> depths_;    ///< relative to the mesh's centre
  int tilesX_, tilesY_;
  std::vector<std::size_t> begin_;  ///< of each tile's faces in binned_
  std::vector<Index> binned_;
};

/// The late fragments of a pixel by their definition (docs/02-method.md, The k-buffer), without a k-buffer: of those
/// that have come the k farthest are kept; nearer than the nearest of these, once others have gone, is late. So is an
/// exit at the place of an entry that it should have gone before.
std::uint32_t countLateByDefinition(std::span<const ExactFragment> fragments, int k);

}  // namespace havs::test
