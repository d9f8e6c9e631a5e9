#include "mesh/defects.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cmath>

#include "core/error.h"
#include "core/parallel.h"
#include "mesh/cell_quality.h"
#include "mesh/overlaps.h"
#include "mesh/shared_corners.h"
#include "mesh/weld.h"

namespace havs {
namespace {

/// How many of [0, n) have a property, and the first that has.
struct Tally {
  std::size_t count = 0;
  std::size_t first = 0;
};

template <class Property>
Tally tally(std::size_t n, const Property& has) {
  std::atomic<std::size_t> count = 0;
  std::atomic<std::size_t> first = n;
  parallelBlocks(0, n, kGrain, [&](std::size_t begin, std::size_t end) {
    std::size_t mine = 0, myFirst = n;
    for (std::size_t i = begin; i < end; ++i) {
      if (!has(i)) continue;
      if (mine++ == 0) myFirst = i;
    }
    count += mine;
    std::size_t known = first;
    while (myFirst < known && !first.compare_exchange_weak(known, myFirst)) {
    }
  });
  return {count, count > 0 ? first.load() : 0};
}

std::vector<char> usedPoints(const TetMesh& mesh) {
  std::vector<char> used(mesh.points.size(), 0);
  parallelFor(0, mesh.tetrahedra.size(), kGrain, [&](std::size_t i) {
    for (const Index point : mesh.tetrahedra[i]) std::atomic_ref(used[point]).store(1, std::memory_order_relaxed);
  });
  return used;
}

bool isFinite(const Field& field, std::size_t tuple) {
  const auto n = static_cast<std::size_t>(field.components);
  for (std::size_t c = 0; c < n; ++c)
    if (!std::isfinite(field.values[tuple * n + c])) return false;
  return true;
}

/// Points first, then cells: `first` is the number of a point unless only cell values are not finite.
Tally nonFiniteScalars(const TetMesh& mesh) {
  const auto broken = [](const std::vector<Field>& fields) {
    return [&fields](std::size_t i) {
      return !std::all_of(fields.begin(), fields.end(), [&](const Field& field) { return isFinite(field, i); });
    };
  };
  const Tally points = tally(mesh.pointFields.empty() ? 0 : mesh.points.size(), broken(mesh.pointFields));
  const Tally cells = tally(mesh.cellFields.empty() ? 0 : mesh.tetrahedra.size(), broken(mesh.cellFields));
  return {points.count + cells.count, points.count > 0 ? points.first : cells.first};
}

}  // namespace

std::string describe(const Defect& defect) {
  return fmt::format("{}: {}, the first number {}; {}", defect.name, defect.count, defect.first, defect.repair);
}

namespace {

/// What inspectMesh looks for, in the order of its rows.
struct Findings {
  Tally inverted, flat, duplicate, overfull, overlapping, unreferenced, nonFinitePoints, nonFiniteScalars;
};

std::vector<Defect> rowsOf(const Findings& findings) {
  std::vector<Defect> defects;
  const auto add = [&](const char* name, const Tally& found, const char* repair) {
    defects.push_back({name, found.count, found.first, repair});
  };
  add("inverted_cells", findings.inverted, "turned");
  add("flat_cells", findings.flat, "left out");
  add("duplicate_cells", findings.duplicate, "left out, the first stays");
  add("overfull_faces", findings.overfull, "kept: their cells are joined in pairs in the order of their numbers");
  add("overlapping_cells", findings.overlapping,
      "kept: rays see each place once, but of several cells there none is the right one");
  add("unreferenced_points", findings.unreferenced, "left out");
  add("non_finite_points", findings.nonFinitePoints, "left out with the cells that use them");
  add("non_finite_scalars", findings.nonFiniteScalars, "kept: the cells they touch are holes when that field is drawn");
  return defects;
}

}  // namespace

std::vector<Defect> inspectMesh(const TetMesh& mesh, bool overlaps) {
  const std::vector<CellState> states = cellStates(mesh);
  const std::size_t cells = mesh.tetrahedra.size();
  Findings found;
  found.inverted = tally(cells, [&](std::size_t i) { return states[i] == CellState::inverted; });
  found.flat = tally(cells, [&](std::size_t i) { return states[i] == CellState::flat; });
  if (!sharesOnlyPlainFaces(mesh)) {
    const std::vector<char> duplicate = duplicateCells(mesh);
    found.duplicate = tally(cells, [&](std::size_t i) { return duplicate[i] != 0; });
    const OverfullFaces overfull = overfullFaces(mesh);
    found.overfull = {overfull.count, overfull.firstCell};
  }
  if (overlaps) {
    const OverlappingCells overlapping = overlappingCells(mesh);
    found.overlapping = {overlapping.count, overlapping.first};
  }
  const std::vector<char> used = usedPoints(mesh);
  found.unreferenced = tally(used.size(), [&](std::size_t i) { return !used[i]; });
  found.nonFinitePoints = tally(mesh.points.size(), [&](std::size_t i) { return !isFinite(mesh.points[i]); });
  found.nonFiniteScalars = nonFiniteScalars(mesh);
  std::vector<Defect> rows = rowsOf(found);
  if (!overlaps) leaveOutOverlaps(rows);
  return rows;
}

std::vector<Defect> inspectFields(const TetMesh& mesh) {
  Findings found;
  found.nonFiniteScalars = nonFiniteScalars(mesh);
  return rowsOf(found);
}

bool isSound(const TetMesh& mesh) {
  const std::vector<CellState> states = cellStates(mesh);
  if (tally(states.size(), [&](std::size_t i) { return states[i] != CellState::sound; }).count > 0) return false;
  const std::vector<char> used = usedPoints(mesh);  // and finite, as their cells are sound
  return tally(used.size(), [&](std::size_t i) { return !used[i]; }).count == 0;
}

namespace {

void turnInvertedCells(TetMesh& mesh, const std::vector<CellState>& states) {
  parallelFor(0, mesh.tetrahedra.size(), kGrain, [&](std::size_t i) {
    if (states[i] == CellState::inverted) std::swap(mesh.tetrahedra[i][2], mesh.tetrahedra[i][3]);
  });
}

void keepCells(TetMesh& mesh, const std::vector<char>& keep) {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < keep.size(); ++i)
    if (keep[i]) mesh.tetrahedra[kept++] = mesh.tetrahedra[i];
  if (kept == keep.size()) return;
  mesh.tetrahedra.resize(kept);
  for (Field& field : mesh.cellFields) keepTuples(keep, field);
}

void keepUsedPoints(TetMesh& mesh) {
  const std::vector<char> used = usedPoints(mesh);
  if (std::find(used.begin(), used.end(), 0) == used.end()) return;
  const std::vector<Index> newNumber = keepPoints(used, mesh.points, mesh.pointFields);
  parallelFor(0, mesh.tetrahedra.size(), kGrain, [&](std::size_t i) {
    for (Index& point : mesh.tetrahedra[i]) point = newNumber[point];
  });
}

void note(TetMesh& mesh, std::size_t count, const char* what) {
  if (count > 0) mesh.notes.push_back(fmt::format("{} {}", count, what));
}

}  // namespace

TetMesh repairMesh(TetMesh mesh) {
  const std::vector<CellState> states = cellStates(mesh);
  const std::size_t cells = mesh.tetrahedra.size();
  const std::vector<char> duplicate = duplicateCells(mesh);
  const auto count = [&](CellState state) {
    return tally(cells,
                 [&](std::size_t i) { return states[i] == state && (state == CellState::notFinite || !duplicate[i]); })
        .count;
  };
  note(mesh, count(CellState::inverted), "inverted cells were turned");
  note(mesh, count(CellState::flat), "flat cells were left out");
  note(mesh, tally(cells, [&](std::size_t i) { return duplicate[i] && states[i] != CellState::notFinite; }).count,
       "duplicate cells were left out");
  note(mesh, count(CellState::notFinite), "cells with a point that is not finite were left out");

  turnInvertedCells(mesh, states);
  std::vector<char> keep(cells);
  parallelFor(0, cells, kGrain, [&](std::size_t i) {
    keep[i] = !duplicate[i] && (states[i] == CellState::sound || states[i] == CellState::inverted);
  });
  keepCells(mesh, keep);
  if (mesh.tetrahedra.empty())
    failInput(fmt::format("none of the {} cells encloses a volume", cells), "", "look at the mesh with 'havs info'");
  const std::size_t points = mesh.points.size();
  keepUsedPoints(mesh);
  note(mesh, points - mesh.points.size(), "points that no cell uses were left out");
  return mesh;
}

}  // namespace havs
