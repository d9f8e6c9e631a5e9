#include "render/native/face_bins.h"

#include <algorithm>
#include <array>

#include "core/parallel.h"

namespace havs {
namespace {

constexpr std::size_t kBlocks = 32;  // more would need more memory for the counts of large pictures

constexpr std::int32_t kBehindEye = -1;

/// Of a place along an axis: the first pixel whose centre lies behind it and the last whose centre lies before it, both
/// by a margin for the rounding of the divisions. Beyond the picture, pixels before and behind all of it.
std::array<std::int32_t, 2> pixelsAt(double place, int size) {
  constexpr double kMargin = 1e-6;
  const double inside = std::clamp(place, -1.0, size + 1.0) + 1.5;  // positive, so that a cast rounds down
  return {std::max(static_cast<std::int32_t>(inside - kMargin) - 1, 0),
          std::min(static_cast<std::int32_t>(inside + kMargin) - 2, size - 1)};
}

}  // namespace

TileGrid tileGrid(int width, int height, int side) {
  return {side, (width + side - 1) / side, (height + side - 1) / side};
}

void FaceBins::findTiles(const RasterMesh& mesh, std::size_t pointCount, const Faces& faces, const TileGrid& grid) {
  placePoints(mesh, pointCount, grid);
  findBoxes(mesh.faces, faces.size());
  parallelFor(0, faces.size(), kGrain,
              [&](std::size_t f) { boxes_[f].boundary = faces.isBoundary(static_cast<Index>(f)) ? 1 : 0; });
}

void FaceBins::findTilesOfCells(const RasterMesh& mesh, std::size_t pointCount, std::size_t cellCount,
                                const TileGrid& grid) {
  placePoints(mesh, pointCount, grid);
  findBoxes(mesh.cells, cellCount);
}

void FaceBins::placePoints(const RasterMesh& mesh, std::size_t pointCount, const TileGrid& grid) {
  grid_ = grid;
  pixels_.resize(pointCount);
  parallelFor(0, pointCount, kGrain, [&](std::size_t i) {
    const RasterPoint& p = mesh.points[i];
    pixels_[i].left = kBehindEye;
    if (!(p.w > 0)) return;
    const auto [left, right] = pixelsAt(p.column, mesh.width);
    const auto [top, bottom] = pixelsAt(p.row, mesh.height);
    pixels_[i] = {left, top, right, bottom};
  });
}

/// Of faces or cells, by their corners.
template <std::size_t kCorners>
void FaceBins::findBoxes(const std::uint32_t (*corners)[kCorners], std::size_t count) {
  boxes_.resize(count);
  const float perSide = 1.0f / static_cast<float>(grid_.side);
  const auto tileOf = [&](std::int32_t pixel) {
    return static_cast<std::uint16_t>((static_cast<float>(pixel) + 0.5f) * perSide);
  };
  const TileBox none{1, 1, 0, 0, 0};
  const TileBox all{0, 0, static_cast<std::uint16_t>(grid_.across - 1), static_cast<std::uint16_t>(grid_.down - 1), 0};
  parallelFor(0, count, kGrain, [&](std::size_t i) {
    PixelBox whole = pixels_[corners[i][0]];
    std::int32_t mostLeft = whole.left;
    for (std::size_t j = 1; j < kCorners; ++j) {
      const PixelBox& p = pixels_[corners[i][j]];
      whole.left = std::min(whole.left, p.left);
      mostLeft = std::max(mostLeft, p.left);
      whole.right = std::max(whole.right, p.right);
      whole.top = std::min(whole.top, p.top);
      whole.bottom = std::max(whole.bottom, p.bottom);
    }
    if (whole.left == kBehindEye) {
      boxes_[i] = mostLeft == kBehindEye ? none : all;
    } else {
      const bool empty = whole.left > whole.right || whole.top > whole.bottom;
      boxes_[i] =
          empty ? none : TileBox{tileOf(whole.left), tileOf(whole.top), tileOf(whole.right), tileOf(whole.bottom), 0};
    }
  });
}

/// The tiles of [firstTile, lastTile) that the face may cover.
template <class Visit>
inline void FaceBins::visitTiles(Index face, std::size_t firstTile, std::size_t lastTile, const Visit& visit) const {
  const TileBox box = boxes_[face];
  if (box.left > box.right) return;
  for (std::size_t y = box.top; y <= box.bottom; ++y) {
    const std::size_t row = y * static_cast<std::size_t>(grid_.across);
    for (std::size_t x = box.left; x <= box.right; ++x)
      if (const std::size_t tile = row + x; tile >= firstTile && tile < lastTile) visit(tile);
  }
}

void FaceBins::count(std::span<const Index> order) {
  order_ = order;
  const std::size_t tiles = grid_.count();
  blocks_ = std::clamp<std::size_t>(order.size() / kGrain, 1, kBlocks);
  counts_.assign(blocks_ * tiles, 0);
  parallelFor(0, blocks_, 1, [&](std::size_t block) {
    std::uint32_t* counts = &counts_[block * tiles];
    for (std::size_t i = order.size() * block / blocks_; i < order.size() * (block + 1) / blocks_; ++i)
      visitTiles(order[i], 0, tiles, [&](std::size_t tile) { ++counts[tile]; });
  });
  ofTile_.assign(tiles, 0);
  pairs_ = 0;
  for (std::size_t block = 0; block < blocks_; ++block)
    for (std::size_t tile = 0; tile < tiles; ++tile) ofTile_[tile] += counts_[block * tiles + tile];
  for (const std::size_t n : ofTile_) pairs_ += n;
  firstTile_ = lastTile_ = 0;
}

std::size_t FaceBins::fill(std::size_t firstTile, std::size_t mostPairs) {
  const std::size_t tiles = grid_.count();
  firstTile_ = lastTile_ = firstTile;
  begins_.assign(1, 0);
  while (lastTile_ < tiles && (lastTile_ == firstTile_ || begins_.back() + ofTile_[lastTile_] <= mostPairs))
    begins_.push_back(begins_.back() + ofTile_[lastTile_++]);
  lists_.resize(begins_.back());
  parallelFor(0, blocks_, 1, [&](std::size_t block) {
    std::vector<std::size_t> next(lastTile_ - firstTile_);
    for (std::size_t tile = firstTile_; tile < lastTile_; ++tile) {
      std::size_t at = begins_[tile - firstTile_];
      for (std::size_t before = 0; before < block; ++before) at += counts_[before * tiles + tile];
      next[tile - firstTile_] = at;
    }
    for (std::size_t i = order_.size() * block / blocks_; i < order_.size() * (block + 1) / blocks_; ++i) {
      const Index face = order_[i];
      const std::uint32_t listed = face | (boxes_[face].boundary != 0 ? kBoundaryBit : 0u);
      visitTiles(face, firstTile_, lastTile_, [&](std::size_t tile) { lists_[next[tile - firstTile_]++] = listed; });
    }
  });
  return lastTile_;
}

std::span<const std::uint32_t> FaceBins::facesOf(std::size_t tile) const {
  const std::size_t i = tile - firstTile_;
  return std::span(lists_).subspan(begins_[i], begins_[i + 1] - begins_[i]);
}

}  // namespace havs
