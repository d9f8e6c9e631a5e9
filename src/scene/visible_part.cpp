// What shows nothing need not be drawn: cells over whose scalars the transfer function is clear everywhere, and that no
// isosurface crosses. What is left has more boundary; rays leave and enter it, which the inside-count of the k-buffer
// takes as it comes.
#include "scene/visible_part.h"

#include <algorithm>
#include <atomic>

#include "core/parallel.h"
#include "scene/shown_scalars.h"

namespace havs {
namespace {

ShownScalars shownScalars(const PreparedScene& prepared, const WhatShows& shows) {
  if (!shows.isosurfaces) return {prepared.curve, shows.volume, {}};
  return {prepared.curve, shows.volume, prepared.isosurfaces};
}

bool isShown(const PreparedScene& prepared, const ShownScalars& shows, std::size_t cell) {
  const auto& scalars = prepared.scalars;
  if (prepared.field.centering == Centering::cell) return shows.meet(scalars[cell], scalars[cell]);
  const auto& [i, j, k, l] = prepared.mesh.tetrahedra[cell];
  const auto [low, high] = std::minmax({scalars[i], scalars[j], scalars[k], scalars[l]});
  return shows.meet(low, high);
}

/// What stays of a list, numbered anew in the same order.
class Kept {
 public:
  explicit Kept(const std::vector<unsigned char>& flags) : numbers_(flags.size(), kNoIndex) {
    for (std::size_t i = 0; i < flags.size(); ++i)
      if (flags[i] != 0) numbers_[i] = static_cast<Index>(count_++);
  }
  std::size_t count() const { return count_; }
  /// kNoIndex where it does not stay.
  Index operator[](Index old) const { return old == kNoIndex ? kNoIndex : numbers_[old]; }
  /// place(i) is what becomes of item i of the old list.
  template <class Value, class Place>
  std::vector<Value> make(const Place& place) const {
    std::vector<Value> values(count_);
    parallelFor(0, numbers_.size(), kGrain, [&](std::size_t i) {
      if (numbers_[i] != kNoIndex) values[numbers_[i]] = place(i);
    });
    return values;
  }

 private:
  std::vector<Index> numbers_;
  std::size_t count_ = 0;
};

Kept pointsOf(const PreparedScene& whole, const std::vector<unsigned char>& shown) {
  std::vector<unsigned char> used(whole.points.size(), 0);
  parallelFor(0, shown.size(), kGrain, [&](std::size_t c) {
    if (shown[c] == 0) return;
    for (const Index p : whole.mesh.tetrahedra[c]) std::atomic_ref(used[p]).store(1, std::memory_order_relaxed);
  });
  return Kept(used);
}

Kept facesOf(const PreparedScene& whole, const std::vector<unsigned char>& shown) {
  const auto isShown = [&](Index cell) { return cell != kNoIndex && shown[cell] != 0; };
  std::vector<unsigned char> used(whole.faces.size());
  parallelFor(0, used.size(), kGrain, [&](std::size_t f) {
    const auto& [first, second] = whole.faces.cells[f];
    used[f] = isShown(first) || isShown(second) ? 1 : 0;
  });
  return Kept(used);
}

/// A face that has lost its first cell is turned over: the normal points out of the first.
Faces partOf(const Faces& whole, const Kept& points, const Kept& cells, const Kept& faces) {
  Faces part;
  const auto losesFirst = [&](std::size_t f) { return cells[whole.cells[f][0]] == kNoIndex; };
  part.vertices = faces.make<std::array<Index, 3>>([&](std::size_t f) {
    const auto& [a, b, c] = whole.vertices[f];
    return losesFirst(f) ? std::array{points[a], points[c], points[b]} : std::array{points[a], points[b], points[c]};
  });
  part.cells = faces.make<std::array<Index, 2>>([&](std::size_t f) {
    const auto& [first, second] = whole.cells[f];
    return losesFirst(f) ? std::array{cells[second], kNoIndex} : std::array{cells[first], cells[second]};
  });
  part.ofCell = cells.make<std::array<Index, 4>>([&](std::size_t c) {
    const auto& [i, j, k, l] = whole.ofCell[c];
    return std::array{faces[i], faces[j], faces[k], faces[l]};
  });
  part.boundaryCount = 2 * part.size() - 4 * part.ofCell.size();  // as of any mesh (buildFaces)
  return part;
}

}  // namespace

std::vector<unsigned char> shownCells(const PreparedScene& prepared, const WhatShows& what) {
  const ShownScalars shows = shownScalars(prepared, what);
  std::vector<unsigned char> shown(prepared.mesh.tetrahedra.size());
  parallelFor(0, shown.size(), kGrain, [&](std::size_t c) { shown[c] = isShown(prepared, shows, c) ? 1 : 0; });
  return shown;
}

bool hasClearCells(const PreparedScene& prepared, const WhatShows& what) {
  const ShownScalars shows = shownScalars(prepared, what);
  std::atomic<bool> found{false};
  parallelFor(0, prepared.mesh.tetrahedra.size(), kGrain, [&](std::size_t c) {
    if (!found.load(std::memory_order_relaxed) && !isShown(prepared, shows, c))
      found.store(true, std::memory_order_relaxed);
  });
  return found;
}

std::optional<PreparedScene> visiblePart(const PreparedScene& whole, const WhatShows& what) {
  const std::vector<unsigned char> shown = shownCells(whole, what);
  const Kept cells(shown);
  if (cells.count() == shown.size()) return std::nullopt;
  const Kept points = pointsOf(whole, shown), faces = facesOf(whole, shown);

  PreparedScene part = withoutMesh(whole);
  part.mesh.points = points.make<Vec3>([&](std::size_t p) { return whole.mesh.points[p]; });
  part.mesh.tetrahedra = cells.make<Tetrahedron>([&](std::size_t c) {
    const auto& [i, j, k, l] = whole.mesh.tetrahedra[c];
    return Tetrahedron{points[i], points[j], points[k], points[l]};
  });
  part.points = points.make<Vec3>([&](std::size_t p) { return whole.points[p]; });
  const auto scalar = [&](std::size_t i) { return whole.scalars[i]; };
  part.scalars = whole.facts().cellData ? cells.make<double>(scalar) : points.make<double>(scalar);
  part.faces = partOf(whole.faces, points, cells, faces);
  part.pointsInWhole = points.make<Index>([](std::size_t p) { return static_cast<Index>(p); });
  part.facesInWhole = faces.make<Index>([](std::size_t f) { return static_cast<Index>(f); });
  part.whole = &whole;
  return part;
}

}  // namespace havs
