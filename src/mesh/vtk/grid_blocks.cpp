#include "mesh/vtk/grid_blocks.h"

#include <algorithm>
#include <iterator>
#include <span>

#include "core/error.h"
#include "mesh/cell_shapes.h"
#include "mesh/weld.h"

namespace havs {
namespace {

bool sameKind(const Field& a, const Field& b) { return a.name == b.name && a.components == b.components; }

const Field* findLike(const Field& field, const std::vector<Field>& fields) {
  const auto found = std::ranges::find_if(fields, [&](const Field& other) { return sameKind(field, other); });
  return found == fields.end() ? nullptr : &*found;
}

/// Appends to `fields` those of the next block; what only one of the two has goes, and is noted.
void joinFields(std::vector<Field>& fields, const std::vector<Field>& next, const char* kind,
                std::vector<std::string>& notes) {
  const auto noteGone = [&](const Field& field) {
    const std::string text =
        "left out the " + std::string(kind) + " field '" + field.name + "', which not every block has";
    if (std::ranges::find(notes, text) == notes.end()) notes.push_back(text);
  };
  for (const Field& field : next)
    if (!findLike(field, fields)) noteGone(field);
  std::erase_if(fields, [&](Field& field) {
    const Field* more = findLike(field, next);
    if (more)
      field.values.insert(field.values.end(), more->values.begin(), more->values.end());
    else
      noteGone(field);
    return !more;
  });
}

bool hasVolume(const CellSoup& cells) {
  return std::ranges::any_of(cells.types, [](std::uint8_t type) {
    const CellShape& shape = cellShape(type);
    return !shape.name || shape.rule != CutRule::leaveOut;  // an unknown type is reported when it is cut
  });
}

/// Surfaces beside the volume (boundary parts of EnSight or CGNS) have other fields and are not drawn.
void leaveOutSurfaces(GridBlocks& blocks) {
  const bool volume = !blocks.structured.empty() || std::ranges::any_of(blocks.cells, hasVolume);
  if (!volume) return;  // cutting says what is there instead
  const std::size_t left = std::erase_if(blocks.cells, [](const CellSoup& cells) { return !hasVolume(cells); });
  if (left > 0) blocks.notes.push_back("left out " + std::to_string(left) + " blocks without three-dimensional cells");
}

/// Calls renumber(number) on every point number of a cell; counts in a polyhedron's face stream stay.
template <class Renumber>
void renumberCell(std::uint8_t type, std::span<std::int64_t> cell, const Renumber& renumber) {
  constexpr std::uint8_t kPolyhedron = 42;
  if (type != kPolyhedron) {
    for (std::int64_t& point : cell) renumber(point);
    return;
  }
  for (std::size_t i = 1; i < cell.size();) {
    const std::size_t corners =
        std::min(static_cast<std::size_t>(std::max<std::int64_t>(cell[i], 0)), cell.size() - i - 1);
    for (std::size_t corner = i + 1; corner <= i + corners; ++corner) renumber(cell[corner]);
    i += corners + 1;
  }
}

template <class Renumber>
void renumberPoints(CellSoup& cells, const Renumber& renumber) {
  for (std::size_t cell = 0; cell < cells.types.size(); ++cell) {
    const auto begin = cells.connectivity.begin() + cells.offsets[cell];
    renumberCell(cells.types[cell], std::span(begin, cells.connectivity.begin() + cells.offsets[cell + 1]), renumber);
  }
}

void append(CellSoup& cells, CellSoup next, std::vector<std::string>& notes) {
  const auto shift = static_cast<std::int64_t>(cells.points.size());
  const auto nextPoints = static_cast<std::int64_t>(next.points.size());
  // A number outside its own block stays outside the whole, so that cutting reports it.
  renumberPoints(next, [&](std::int64_t& point) { point = point >= 0 && point < nextPoints ? point + shift : -1; });
  cells.points.insert(cells.points.end(), next.points.begin(), next.points.end());
  cells.types.insert(cells.types.end(), next.types.begin(), next.types.end());
  for (std::size_t i = 1; i < next.offsets.size(); ++i)
    cells.offsets.push_back(next.offsets[i] + static_cast<std::int64_t>(cells.connectivity.size()));
  cells.connectivity.insert(cells.connectivity.end(), next.connectivity.begin(), next.connectivity.end());
  joinFields(cells.pointFields, next.pointFields, "point", notes);
  joinFields(cells.cellFields, next.cellFields, "cell", notes);
}

TetMesh cutCells(std::vector<CellSoup> blocks, std::vector<std::string>& notes, const std::string& where) {
  CellSoup all = std::move(blocks.front());
  for (std::size_t i = 1; i < blocks.size(); ++i) append(all, std::move(blocks[i]), notes);
  return cutIntoTetrahedra(std::move(all), where);
}

/// Hidden cells must be cut with the others, for the parity of the cuts, and ride along as a field.
TetMesh cutStructured(StructuredBlock grid, const std::string& where) {
  constexpr const char* kHidden = "havs hidden cell";
  const bool someHidden = !grid.hiddenCell.empty();
  if (someHidden) grid.cellFields.push_back({kHidden, 1, {grid.hiddenCell.begin(), grid.hiddenCell.end()}});
  TetMesh mesh = cutStructuredGrid(grid.size, std::move(grid.points), std::move(grid.blank),
                                   std::move(grid.pointFields), std::move(grid.cellFields), where);
  if (!someHidden) return mesh;
  const std::vector<double> hidden = std::move(mesh.cellFields.back().values);
  mesh.cellFields.pop_back();
  std::vector<char> keep(hidden.size());
  std::ranges::transform(hidden, keep.begin(), [](double flag) { return flag == 0; });
  for (Field& field : mesh.cellFields) keepTuples(keep, field);
  std::size_t kept = 0;
  for (std::size_t i = 0; i < keep.size(); ++i)
    if (keep[i]) mesh.tetrahedra[kept++] = mesh.tetrahedra[i];
  if (kept == 0) failInput("every cell of the grid is blanked", where);
  mesh.tetrahedra.resize(kept);
  mesh.sourceCells -= static_cast<std::size_t>(std::ranges::count(grid.hiddenCell, 1));
  return mesh;
}

void append(TetMesh& mesh, TetMesh next, std::vector<std::string>& notes, const std::string& where) {
  if (mesh.points.size() + next.points.size() >= kNoIndex)
    failInput("its blocks have more points than can be numbered", where);
  const auto shift = static_cast<Index>(mesh.points.size());
  for (Tetrahedron& tetrahedron : next.tetrahedra)
    for (Index& point : tetrahedron) point += shift;
  mesh.points.insert(mesh.points.end(), next.points.begin(), next.points.end());
  mesh.tetrahedra.insert(mesh.tetrahedra.end(), next.tetrahedra.begin(), next.tetrahedra.end());
  joinFields(mesh.pointFields, next.pointFields, "point", notes);
  joinFields(mesh.cellFields, next.cellFields, "cell", notes);
  mesh.sourceCells += next.sourceCells;
  std::ranges::move(next.notes, std::back_inserter(mesh.notes));
}

}  // namespace

TetMesh meshFromBlocks(GridBlocks blocks, const std::string& where) {
  leaveOutSurfaces(blocks);
  std::vector<TetMesh> parts;
  if (!blocks.cells.empty()) parts.push_back(cutCells(std::move(blocks.cells), blocks.notes, where));
  for (StructuredBlock& grid : blocks.structured) parts.push_back(cutStructured(std::move(grid), where));
  if (parts.empty()) failInput("holds no cells", where);

  TetMesh mesh = std::move(parts.front());
  for (std::size_t i = 1; i < parts.size(); ++i) append(mesh, std::move(parts[i]), blocks.notes, where);
  mesh.notes.insert(mesh.notes.begin(), blocks.notes.begin(), blocks.notes.end());
  return mesh;
}

}  // namespace havs
