// Cells (and faces) of the same points are found by sorting them into buckets by their lowest point number, a counting
// sort; the few in a bucket are then sorted by their other points. Ties go by cell number, so nothing depends on
// threads.
#include "mesh/shared_corners.h"

#include <algorithm>
#include <atomic>

#include "core/parallel.h"
#include "mesh/face_matching.h"
#include "mesh/spatial_order.h"

namespace havs {
namespace {

/// The points of a cell or face but the lowest, in order, and the cell's number.
template <std::size_t N>
struct Entry {
  std::array<Index, N> others;
  Index cell;
  bool operator<(const Entry& b) const { return others != b.others ? others < b.others : cell < b.cell; }
};

/// Buckets of entries by lowest point: entries[begins[p] .. begins[p + 1]) have the lowest point p. `forEachOf(cell,
/// visit)` calls visit(lowest, others) for each item of a cell. Calls `use(bucket)` with each sorted bucket, from
/// several threads.
template <std::size_t N, class ForEachOf, class Use>
void visitBuckets(std::size_t points, std::size_t cells, const ForEachOf& forEachOf, const Use& use) {
  std::vector<std::size_t> ends(points + 1, 0);
  parallelFor(0, cells, kGrain, [&](std::size_t cell) {
    forEachOf(cell, [&](Index lowest, const std::array<Index, N>&) {
      std::atomic_ref(ends[lowest + 1]).fetch_add(1, std::memory_order_relaxed);
    });
  });
  for (std::size_t p = 0; p < points; ++p) ends[p + 1] += ends[p];
  std::vector<Entry<N>> entries(ends[points]);
  // ends[p] runs from the begin of bucket p to its end, which is the begin of bucket p + 1.
  parallelFor(0, cells, kGrain, [&](std::size_t cell) {
    forEachOf(cell, [&](Index lowest, const std::array<Index, N>& others) {
      const std::size_t at = std::atomic_ref(ends[lowest]).fetch_add(1, std::memory_order_relaxed);
      entries[at] = {others, static_cast<Index>(cell)};
    });
  });
  parallelFor(0, points, kGrain, [&](std::size_t p) {
    const auto begin = entries.begin() + static_cast<std::ptrdiff_t>(p == 0 ? 0 : ends[p - 1]);
    const auto end = entries.begin() + static_cast<std::ptrdiff_t>(ends[p]);
    std::sort(begin, end);
    if (begin != end) use(begin, end);
  });
}

Tetrahedron sorted(Tetrahedron t) {
  const auto order = [&](std::size_t i, std::size_t j) {
    if (t[j] < t[i]) std::swap(t[i], t[j]);
  };
  order(0, 1);
  order(2, 3);
  order(0, 2);
  order(1, 3);
  order(1, 2);
  return t;
}

}  // namespace

bool sharesOnlyPlainFaces(const TetMesh& mesh) {
  std::atomic<bool> distinct = true;
  parallelFor(0, mesh.tetrahedra.size(), kGrain, [&](std::size_t cell) {
    const auto& [i, j, k, l] = mesh.tetrahedra[cell];
    if (i == j || i == k || i == l || j == k || j == l || k == l) distinct.store(false, std::memory_order_relaxed);
  });
  // Numbers that follow space cost less than what they save.
  return distinct && matchFaces(renumbered(mesh, spatialNumbers(mesh.points, mesh.tetrahedra))).plain;
}

std::vector<char> duplicateCells(const TetMesh& mesh) {
  std::vector<char> duplicate(mesh.tetrahedra.size(), 0);
  const auto forEachOf = [&](std::size_t cell, const auto& visit) {
    const Tetrahedron t = sorted(mesh.tetrahedra[cell]);
    visit(t[0], std::array{t[1], t[2], t[3]});
  };
  visitBuckets<3>(mesh.points.size(), mesh.tetrahedra.size(), forEachOf, [&](auto begin, auto end) {
    for (auto entry = begin + 1; entry != end; ++entry) duplicate[entry->cell] = entry->others == entry[-1].others;
  });
  return duplicate;
}

OverfullFaces overfullFaces(const TetMesh& mesh) {
  const auto forEachOf = [&](std::size_t cell, const auto& visit) {
    const Tetrahedron t = sorted(mesh.tetrahedra[cell]);
    if (t[0] == t[1] || t[1] == t[2] || t[2] == t[3]) return;
    visit(t[0], std::array{t[1], t[2]});
    visit(t[0], std::array{t[1], t[3]});
    visit(t[0], std::array{t[2], t[3]});
    visit(t[1], std::array{t[2], t[3]});
  };
  std::atomic<std::size_t> count = 0;
  std::atomic<std::size_t> firstCell = mesh.tetrahedra.size();
  visitBuckets<2>(mesh.points.size(), mesh.tetrahedra.size(), forEachOf, [&](auto begin, auto end) {
    for (auto run = begin, next = begin; run != end; run = next) {
      while (next != end && next->others == run->others) ++next;
      if (next - run <= 2) continue;
      ++count;
      std::size_t known = firstCell;
      while (run->cell < known && !firstCell.compare_exchange_weak(known, run->cell)) {
      }
    }
  });
  return {count, count > 0 ? firstCell.load() : 0};
}

}  // namespace havs
