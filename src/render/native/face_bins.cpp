#include "render/native/face_bins.h"

#include <algorithm>
#include <cmath>

#include "core/parallel.h"

namespace havs {
namespace {

constexpr std::size_t kGrain = 8192;
constexpr std::size_t kBlocks = 32;  // more would need more memory for the counts of large pictures

/// Pixels whose centres lie in [low, high], which is widened a little for the rounding of the divisions.
std::array<double, 2> pixelsIn(double low, double high, int size) {
  constexpr double kMargin = 1e-6;
  return {std::max(std::ceil(low - 0.5 - kMargin), 0.0), std::min(std::floor(high - 0.5 + kMargin), size - 1.0)};
}

}  // namespace

TileGrid tileGrid(int width, int height, int side) {
  return {side, (width + side - 1) / side, (height + side - 1) / side};
}

void FaceBins::findTiles(const RasterMesh& mesh, std::size_t faceCount, const TileGrid& grid) {
  grid_ = grid;
  boxes_.resize(faceCount);
  const auto side = static_cast<double>(grid.side);
  const TileBox all{0, 0, static_cast<std::uint16_t>(grid.across - 1), static_cast<std::uint16_t>(grid.down - 1)};
  parallelFor(0, faceCount, kGrain, [&](std::size_t f) {
    double low[2] = {1e300, 1e300}, high[2] = {-1e300, -1e300};
    bool before = true, behind = true;
    for (const std::uint32_t v : {mesh.faces[f][0], mesh.faces[f][1], mesh.faces[f][2]}) {
      const RasterPoint& p = mesh.points[v];
      before = before && p.w > 0;
      behind = behind && !(p.w > 0);
      low[0] = std::min(low[0], p.column);
      high[0] = std::max(high[0], p.column);
      low[1] = std::min(low[1], p.row);
      high[1] = std::max(high[1], p.row);
    }
    const auto [left, right] = pixelsIn(low[0], high[0], mesh.width);
    const auto [top, bottom] = pixelsIn(low[1], high[1], mesh.height);
    TileBox& box = boxes_[f];
    if (behind || (before && !(left <= right && top <= bottom))) {
      box = {1, 1, 0, 0};
    } else if (!before) {
      box = all;
    } else {
      box = {static_cast<std::uint16_t>(left / side), static_cast<std::uint16_t>(top / side),
             static_cast<std::uint16_t>(right / side), static_cast<std::uint16_t>(bottom / side)};
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

void FaceBins::count(std::span<const Index> order, const Faces& faces) {
  order_ = order;
  faces_ = &faces;
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
      const std::uint32_t listed = face | (faces_->isBoundary(face) ? kBoundaryBit : 0u);
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
