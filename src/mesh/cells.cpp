#include "mesh/cells.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "core/error.h"
#include "core/memory_budget.h"
#include "core/parallel.h"
#include "mesh/cell_check.h"
#include "mesh/cell_cutter.h"
#include "mesh/cell_shapes.h"
#include "mesh/weld.h"

namespace havs {
namespace {

constexpr std::uint8_t kTetra = 10;

/// All cells are tetrahedra: nothing to cut, and with millions of them worth being quick about.
TetMesh takeTetrahedra(CellSoup cells) {
  TetMesh mesh;
  mesh.sourceCells = cells.types.size();
  mesh.tetrahedra.resize(cells.types.size());
  parallelFor(0, cells.types.size(), 4096, [&](std::size_t i) {
    for (std::size_t c = 0; c < 4; ++c)
      mesh.tetrahedra[i][c] = static_cast<Index>(cells.connectivity[static_cast<std::size_t>(cells.offsets[i]) + c]);
  });
  mesh.points = std::move(cells.points);
  mesh.pointFields = std::move(cells.pointFields);
  mesh.cellFields = std::move(cells.cellFields);
  mesh.notes = std::move(cells.notes);
  return mesh;
}

Field gathered(const Field& field, const std::vector<Index>& sources) {
  const auto n = static_cast<std::size_t>(field.components);
  Field result{field.name, field.components, std::vector<double>(sources.size() * n)};
  parallelFor(0, sources.size(), 4096, [&](std::size_t i) {
    for (std::size_t c = 0; c < n; ++c) result.values[i * n + c] = field.values[sources[i] * n + c];
  });
  return result;
}

/// The point numbers of one cell, after welding. A polyhedron's stream holds counts between the numbers.
void gatherCell(const CellSoup& cells, std::size_t cell, bool isPolyhedron, const std::vector<Index>& newNumber,
                std::vector<Index>& result) {
  const auto begin = cells.connectivity.begin() + cells.offsets[cell];
  const auto end = cells.connectivity.begin() + cells.offsets[cell + 1];
  result.assign(begin, end);
  if (newNumber.empty()) return;
  if (!isPolyhedron) {
    for (Index& point : result) point = newNumber[point];
    return;
  }
  for (std::size_t at = 1; at < result.size(); at += result[at] + 1)
    for (std::size_t i = 1; i <= result[at]; ++i) result[at + i] = newNumber[result[at + i]];
}

void noteLeftOut(const std::array<std::size_t, 256>& count, std::vector<std::string>& notes) {
  std::string list;
  for (std::size_t type = 0; type < count.size(); ++type) {
    const CellShape& shape = cellShape(static_cast<std::uint8_t>(type));
    if (count[type] > 0 && shape.rule == CutRule::leaveOut)
      list += fmt::format("{}{} {}", list.empty() ? "" : ", ", count[type], shape.name);
  }
  if (!list.empty()) notes.push_back("left out cells that enclose no volume: " + list);
}

void noteDegenerate(const CellCutter& cutter, std::vector<std::string>& notes) {
  if (cutter.degenerateCells() > 0)
    notes.push_back(fmt::format(
        "{} cells name a point more than once: their pieces of no volume are left out{}", cutter.degenerateCells(),
        cutter.collapsedCells() > 0 ? fmt::format(" ({} of them have no volume at all)", cutter.collapsedCells())
                                    : std::string{}));
}

}  // namespace

TetMesh cutIntoTetrahedra(CellSoup cells, const std::string& where) {
  checkCells(cells, where);
  if (std::all_of(cells.types.begin(), cells.types.end(), [](std::uint8_t type) { return type == kTetra; }))
    return takeTetrahedra(std::move(cells));

  // A cell becomes about as many tetrahedra as it has corners, each with the number of its cell.
  needMemory((sizeof(Tetrahedron) + sizeof(Index)) * static_cast<double>(cells.connectivity.size()),
             fmt::format("cutting {} cells into tetrahedra", cells.types.size()), where);
  // Diagonals are chosen by point number, so pieces that meet in doubled points must be welded before they are cut.
  TetMesh mesh;
  const std::size_t before = cells.points.size();
  const std::vector<Index> newNumber = mergeIdenticalPoints(cells.points, cells.pointFields);
  mesh.notes = std::move(cells.notes);
  if (before > cells.points.size())
    mesh.notes.push_back(fmt::format("welded {} points that were identical to others", before - cells.points.size()));

  CellCutter cutter(cells.points, cells.pointFields);
  std::array<std::size_t, 256> count{};
  std::vector<Index> corners;
  for (std::size_t i = 0; i < cells.types.size(); ++i) {
    ++count[cells.types[i]];
    const CellShape& shape = cellShape(cells.types[i]);
    if (shape.rule == CutRule::leaveOut) continue;
    const bool isPolyhedron = shape.rule == CutRule::polyhedron;
    gatherCell(cells, i, isPolyhedron, newNumber, corners);
    if (isPolyhedron)
      cutter.cutPolyhedron(static_cast<Index>(i), corners);
    else
      cutter.cut(static_cast<Index>(i), shape, corners);
    ++mesh.sourceCells;
  }
  noteLeftOut(count, mesh.notes);
  noteDegenerate(cutter, mesh.notes);
  if (mesh.sourceCells == 0)
    failInput(
        "there are no solid cells, only points, lines or surfaces", where,
        "a volume needs tetrahedra or other solid cells; a closed surface can be filled by TetGen (.stl, .ply, .off)");
  if (cutter.tetrahedra().empty()) failInput("no cell encloses a volume", where, "every cell names points twice");

  mesh.tetrahedra = std::move(cutter.tetrahedra());
  for (const Field& field : cells.cellFields) mesh.cellFields.push_back(gathered(field, cutter.sourceCells()));
  mesh.points = std::move(cells.points);
  mesh.pointFields = std::move(cells.pointFields);
  return mesh;
}

}  // namespace havs
