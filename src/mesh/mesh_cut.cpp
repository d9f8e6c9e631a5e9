// Crossed edges are numbered, and each cell is halved at one of its crossed edges after the other, lowest number first.
// A halving at an edge of a face halves the face; one at another edge leaves it whole in one of the two halves. So how
// a face is cut depends on its own edges alone, and the cells on both sides of it agree without knowing of each other.
#include "mesh/mesh_cut.h"

#include <tbb/parallel_sort.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstdint>

namespace havs {
namespace {

constexpr std::size_t kBlock = 4096;
constexpr std::array<std::array<std::size_t, 2>, 6> kEdges{{{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}}};

using EdgeKey = std::uint64_t;
EdgeKey keyOf(Index a, Index b) { return (EdgeKey{std::min(a, b)} << 32) | std::max(a, b); }

std::size_t blocksOf(std::size_t count) { return (count + kBlock - 1) / kBlock; }

/// One after the other what each block has gathered. Empties them.
template <class Value>
std::vector<Value> joined(std::vector<std::vector<Value>>& blocks) {
  std::vector<std::size_t> begin(blocks.size() + 1, 0);
  for (std::size_t b = 0; b < blocks.size(); ++b) begin[b + 1] = begin[b] + blocks[b].size();
  std::vector<Value> all(begin.back());
  parallelFor(0, blocks.size(), 1, [&](std::size_t b) {
    std::copy(blocks[b].begin(), blocks[b].end(), all.begin() + static_cast<std::ptrdiff_t>(begin[b]));
    blocks[b] = {};
  });
  return all;
}

class Cutter {
 public:
  Cutter(std::span<const Tetrahedron> cells, std::span<const double> levels, std::span<const CellFate> fates)
      : cells_(cells), levels_(levels), fates_(fates) {}

  MeshCut cut() {
    findEdges();
    cutCells();
    placeEdgePoints();
    numberPoints();
    return std::move(result_);
  }

 private:
  /// What a block of cells becomes.
  struct Pieces {
    std::vector<Tetrahedron> tetrahedra;
    std::vector<Index> cells;
    std::vector<signed char> sides;
  };
  /// Of a cell's edges, the numbers among edges_; kNoIndex where it is not crossed.
  using Crossed = std::array<Index, 6>;

  bool crosses(Index a, Index b) const {
    return (levels_[a] > 0 && levels_[b] < 0) || (levels_[a] < 0 && levels_[b] > 0);
  }

  void findEdges() {
    std::vector<std::vector<EdgeKey>> found(blocksOf(cells_.size()));
    parallelFor(0, found.size(), 1, [&](std::size_t block) {
      const std::size_t end = std::min(cells_.size(), (block + 1) * kBlock);
      for (std::size_t c = block * kBlock; c < end; ++c) {
        if (fates_[c] != CellFate::split && fates_[c] != CellFate::above) continue;
        for (const auto& [i, j] : kEdges)
          if (const Index a = cells_[c][i], b = cells_[c][j]; crosses(a, b)) found[block].push_back(keyOf(a, b));
      }
    });
    edges_ = joined(found);
    tbb::parallel_sort(edges_.begin(), edges_.end());
    edges_.erase(std::unique(edges_.begin(), edges_.end()), edges_.end());
  }

  Index numberOf(Index a, Index b) const {
    const EdgeKey key = keyOf(a, b);
    const auto found = std::lower_bound(edges_.begin(), edges_.end(), key);
    return found != edges_.end() && *found == key ? static_cast<Index>(found - edges_.begin()) : kNoIndex;
  }

  void cutCells() {
    std::vector<std::vector<Tetrahedron>> tetrahedra(blocksOf(cells_.size()));
    std::vector<std::vector<Index>> sources(tetrahedra.size());
    std::vector<std::vector<signed char>> sides(tetrahedra.size());
    parallelFor(0, tetrahedra.size(), 1, [&](std::size_t block) {
      Pieces pieces;
      const std::size_t end = std::min(cells_.size(), (block + 1) * kBlock);
      for (std::size_t c = block * kBlock; c < end; ++c) cutCell(c, pieces);
      tetrahedra[block] = std::move(pieces.tetrahedra);
      sources[block] = std::move(pieces.cells);
      sides[block] = std::move(pieces.sides);
    });
    result_.tetrahedra = joined(tetrahedra);
    result_.cells = joined(sources);
    result_.pieceSide = joined(sides);
  }

  void cutCell(std::size_t c, Pieces& pieces) const {
    if (fates_[c] == CellFate::goes) return;
    Crossed crossed;
    crossed.fill(kNoIndex);
    if (!edges_.empty())
      for (std::size_t e = 0; e < 6; ++e)
        if (const Index a = cells_[c][kEdges[e][0]], b = cells_[c][kEdges[e][1]]; crosses(a, b))
          crossed[e] = numberOf(a, b);
    halve(static_cast<Index>(c), cells_[c], 15u, crossed, pieces);
  }

  /// `corners`: bit i is set where corner i is the cell's own.
  void halve(Index cell, const Tetrahedron& piece, unsigned corners, const Crossed& crossed, Pieces& pieces) const {
    std::size_t lowest = 6;
    for (std::size_t e = 0; e < 6; ++e) {
      const unsigned ends = (1u << kEdges[e][0]) | (1u << kEdges[e][1]);
      if (crossed[e] == kNoIndex || (corners & ends) != ends) continue;
      if (lowest == 6 || crossed[e] < crossed[lowest]) lowest = e;
    }
    if (lowest == 6) return add(cell, piece, pieces);
    for (const std::size_t end : kEdges[lowest]) {
      Tetrahedron half = piece;
      half[end] = static_cast<Index>(levels_.size()) + crossed[lowest];
      halve(cell, half, corners & ~(1u << end), crossed, pieces);
    }
  }

  void add(Index cell, const Tetrahedron& piece, Pieces& pieces) const {
    const signed char side = sideOf(piece);
    if (fates_[cell] == CellFate::above && side < 0) return;
    pieces.tetrahedra.push_back(piece);
    pieces.cells.push_back(cell);
    pieces.sides.push_back(side);
  }

  signed char sideOf(const Tetrahedron& piece) const {
    bool above = false, below = false;
    for (const Index p : piece) {
      above = above || (p < levels_.size() && levels_[p] > 0);
      below = below || (p < levels_.size() && levels_[p] < 0);
    }
    return static_cast<signed char>((above ? 1 : 0) - (below ? 1 : 0));
  }

  void placeEdgePoints() {
    result_.edgePoints.resize(edges_.size());
    parallelFor(0, edges_.size(), kBlock, [&](std::size_t e) {
      auto near = static_cast<Index>(edges_[e] >> 32), far = static_cast<Index>(edges_[e] & 0xFFFFFFFFu);
      if (std::abs(levels_[far]) < std::abs(levels_[near])) std::swap(near, far);
      result_.edgePoints[e] = {near, far, levels_[near] / (levels_[near] - levels_[far])};
    });
  }

  /// Old points that a cell still has come first, then those on edges.
  void numberPoints() {
    auto& tetrahedra = result_.tetrahedra;
    const std::size_t firstNew = levels_.size();
    std::vector<Index> number(firstNew + edges_.size(), 0);
    parallelFor(0, tetrahedra.size(), kBlock, [&](std::size_t c) {
      for (const Index p : tetrahedra[c]) std::atomic_ref(number[p]).store(1, std::memory_order_relaxed);
    });
    for (std::size_t p = 0; p < firstNew; ++p) {
      if (number[p] == 0) continue;
      number[p] = static_cast<Index>(result_.keptPoints.size());
      result_.keptPoints.push_back(static_cast<Index>(p));
    }
    for (std::size_t e = 0; e < edges_.size(); ++e)
      number[firstNew + e] = static_cast<Index>(result_.keptPoints.size() + e);
    parallelFor(0, tetrahedra.size(), kBlock, [&](std::size_t c) {
      for (Index& p : tetrahedra[c]) p = number[p];
    });
  }

  std::span<const Tetrahedron> cells_;
  std::span<const double> levels_;
  std::span<const CellFate> fates_;
  std::vector<EdgeKey> edges_;  ///< crossed; in order
  MeshCut result_;
};

}  // namespace

MeshCut cutMesh(std::span<const Tetrahedron> cells, std::span<const double> levels, std::span<const CellFate> fates) {
  return Cutter(cells, levels, fates).cut();
}

}  // namespace havs
