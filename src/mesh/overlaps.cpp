// Which cells overlap. A ray that leaves a place that is in two cells comes out through a face of the boundary, as
// inner faces have a cell on either side: just before it, it is in that face's cell and in another one. So cells
// overlap if and only if a cell of the boundary overlaps another cell. Two cells do not overlap if and only if a plane
// parts them: one of a face, or one along an edge of each (Gottschalk, Lin, Manocha 1996, "OBBTree").
#include "mesh/overlaps.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>

#include "core/parallel.h"
#include "mesh/cell_quality.h"
#include "mesh/local_frame.h"
#include "mesh/shared_corners.h"
#include "mesh/spatial_order.h"

namespace havs {
namespace {

constexpr std::size_t kFewCells = 256;
constexpr std::size_t kWidth = 8;
/// In radii. Distances less than this apart are the same to the k-buffer (core/kbuffer.glsl), too.
constexpr double kDepth = 1e-6;

using Corners = std::array<Vec3, 4>;

struct Box {
  Vec3 low, high;
  bool reaches(const Box& other) const {
    const Vec3 gap = max(low - other.high, other.low - high);
    return std::max({gap.x, gap.y, gap.z}) < -kDepth;
  }
};

Box boxOf(const Corners& p) { return {min(min(p[0], p[1]), min(p[2], p[3])), max(max(p[0], p[1]), max(p[2], p[3]))}; }

Box joined(const Box& a, const Box& b) { return {min(a.low, b.low), max(a.high, b.high)}; }

/// Whether the cells do not overlap along `axis`, of any length but 0.
bool areApartAlong(const Vec3& axis, const Corners& a, const Corners& b) {
  const double length = glm::length(axis);
  if (!(length > 0)) return false;
  const auto [lowA, highA] = std::minmax({dot(axis, a[0]), dot(axis, a[1]), dot(axis, a[2]), dot(axis, a[3])});
  const auto [lowB, highB] = std::minmax({dot(axis, b[0]), dot(axis, b[1]), dot(axis, b[2]), dot(axis, b[3])});
  return std::min(highA, highB) - std::max(lowA, lowB) <= kDepth * length;
}

std::array<Vec3, 6> edgesOf(const Corners& p) {
  return {p[1] - p[0], p[2] - p[0], p[3] - p[0], p[2] - p[1], p[3] - p[1], p[3] - p[2]};
}

bool isFacePlaneBetween(const std::array<Vec3, 6>& edges, const Corners& a, const Corners& b) {
  constexpr std::size_t kOfFace[4][2] = {{0, 1}, {0, 2}, {1, 2}, {3, 4}};
  return std::any_of(std::begin(kOfFace), std::end(kOfFace),
                     [&](const auto& e) { return areApartAlong(cross(edges[e[0]], edges[e[1]]), a, b); });
}

bool overlap(Corners a, Corners b) {
  const Vec3 origin = a[0];  // places near each other lose nothing
  for (Vec3& p : a) p -= origin;
  for (Vec3& p : b) p -= origin;
  const std::array<Vec3, 6> edgesA = edgesOf(a), edgesB = edgesOf(b);
  if (isFacePlaneBetween(edgesA, a, b) || isFacePlaneBetween(edgesB, a, b)) return false;
  for (const Vec3& one : edgesA)
    for (const Vec3& other : edgesB)
      if (areApartAlong(cross(one, other), a, b)) return false;
  return true;
}

/// Cells in the order of their numbers, in boxes of boxes.
class CellTree {
 public:
  CellTree(const std::vector<Vec3>& points, const std::vector<Tetrahedron>& cells) : points_(points), cells_(cells) {
    addLevel(cells.size(), [&](std::size_t c) { return boxOf(cornersOf(c)); });
    while (levels_.back().size() > 1)
      addLevel(levels_.back().size(), [&, below = levels_.size() - 1](std::size_t i) { return levels_[below][i]; });
  }

  Corners cornersOf(std::size_t cell) const {
    const auto& [a, b, c, d] = cells_[cell];
    return {points_[a], points_[b], points_[c], points_[d]};
  }

  /// visit(other) for the cells whose boxes the cell's box reaches into.
  template <class Visit>
  void visitNear(std::size_t cell, const Visit& visit) const {
    const Box box = boxOf(cornersOf(cell));
    visitBelow(levels_.size() - 1, 0, box, [&](std::size_t other) {
      if (other != cell && box.reaches(boxOf(cornersOf(other)))) visit(other);
    });
  }

 private:
  template <class BoxOf>
  void addLevel(std::size_t count, const BoxOf& boxOfItem) {
    std::vector<Box> level((count + kWidth - 1) / kWidth);
    parallelFor(0, level.size(), kFewCells, [&](std::size_t i) {
      level[i] = boxOfItem(i * kWidth);
      for (std::size_t j = i * kWidth + 1; j < std::min(count, (i + 1) * kWidth); ++j)
        level[i] = joined(level[i], boxOfItem(j));
    });
    levels_.push_back(std::move(level));
  }

  template <class Visit>
  void visitBelow(std::size_t level, std::size_t place, const Box& box, const Visit& visit) const {
    if (!box.reaches(levels_[level][place])) return;
    const std::size_t count = level == 0 ? cells_.size() : levels_[level - 1].size();
    for (std::size_t i = place * kWidth; i < std::min(count, (place + 1) * kWidth); ++i) {
      if (level == 0)
        visit(i);
      else
        visitBelow(level - 1, i, box, visit);
    }
  }

  const std::vector<Vec3>& points_;
  const std::vector<Tetrahedron>& cells_;
  std::vector<std::vector<Box>> levels_;
};

}  // namespace

OverlappingCells overlappingCells(const TetMesh& mesh, const Faces& faces, std::span<const Index> numbers) {
  const std::size_t cells = mesh.tetrahedra.size();
  if (cells == 0) return {};
  const std::vector<Vec3> points = localPoints(mesh, localFrame(mesh));
  const CellTree tree(points, mesh.tetrahedra);
  std::vector<char> overlaps(cells, 0);
  std::atomic<bool> any = false;
  const auto look = [&](bool atBoundary) {
    parallelFor(0, cells, kFewCells, [&](std::size_t c) {
      const auto& ofCell = faces.ofCell[c];
      if (atBoundary != std::any_of(ofCell.begin(), ofCell.end(), [&](Index f) { return faces.isBoundary(f); })) return;
      tree.visitNear(c, [&](std::size_t other) {
        if (!overlap(tree.cornersOf(c), tree.cornersOf(other))) return;
        std::atomic_ref(overlaps[c]).store(1, std::memory_order_relaxed);
        std::atomic_ref(overlaps[other]).store(1, std::memory_order_relaxed);
        any.store(true, std::memory_order_relaxed);
      });
    });
  };
  look(true);
  if (!any) return {};
  look(false);
  OverlappingCells found{0, kNoIndex};
  for (std::size_t c = 0; c < cells; ++c) {
    if (!overlaps[c]) continue;
    ++found.count;
    found.first = std::min<std::size_t>(found.first, numbers[c]);
  }
  return found;
}

OverlappingCells overlappingCells(const TetMesh& mesh) {
  const std::vector<CellState> states = cellStates(mesh);
  const std::vector<char> duplicate = duplicateCells(mesh);
  TetMesh kept;
  kept.points = mesh.points;
  std::vector<Index> numbers;
  for (std::size_t c = 0; c < states.size(); ++c) {
    if (duplicate[c] || (states[c] != CellState::sound && states[c] != CellState::inverted)) continue;
    kept.tetrahedra.push_back(mesh.tetrahedra[c]);
    if (states[c] == CellState::inverted) std::swap(kept.tetrahedra.back()[2], kept.tetrahedra.back()[3]);
    numbers.push_back(static_cast<Index>(c));
  }
  const SpatialNumbers order = spatialNumbers(kept.points, kept.tetrahedra);
  kept = renumbered(kept, order);
  std::vector<Index> inFile;
  for (const Index c : order.cells) inFile.push_back(numbers[c]);
  return overlappingCells(kept, buildFaces(kept), inFile);
}

void enterOverlaps(std::vector<Defect>& defects, const OverlappingCells& found) {
  for (Defect& defect : defects) {
    if (defect.name != "overlapping_cells") continue;
    defect.count = found.count;
    defect.first = found.first;
  }
}

void leaveOutOverlaps(std::vector<Defect>& defects) {
  std::erase_if(defects, [](const Defect& defect) { return defect.name == "overlapping_cells"; });
}

}  // namespace havs
