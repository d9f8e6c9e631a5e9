// A structured grid in five tetrahedra a cell. The cut's diagonals turn with the parity of i + j + k, so that the two
// cells at a face cut it at the same diagonal.
#include <fmt/format.h>

#include <algorithm>

#include "core/error.h"
#include "core/memory_budget.h"
#include "core/parallel.h"
#include "mesh/cell_check.h"
#include "mesh/cells.h"

namespace havs {
namespace {

using Size = std::array<std::size_t, 3>;

// Corners of a cell by bits: 1 for i + 1, 2 for j + 1, 4 for k + 1. Each row: the four corners' tetrahedra, then the
// middle one.
constexpr std::array<std::array<int, 4>, 5> kEven = {
    {{0, 1, 2, 4}, {3, 2, 1, 7}, {5, 4, 7, 1}, {6, 7, 4, 2}, {1, 2, 4, 7}}};
constexpr std::array<std::array<int, 4>, 5> kOdd = {
    {{1, 3, 0, 5}, {2, 0, 3, 6}, {4, 6, 5, 0}, {7, 5, 6, 3}, {0, 5, 3, 6}}};

void checkGrid(const Size& size, std::size_t points, const std::vector<int>& blank, const std::string& where) {
  const std::string shape = fmt::format("{} x {} x {}", size[0], size[1], size[2]);
  for (const std::size_t n : size)
    if (n < 2) failInput("a grid of " + shape + " points encloses no volume", where, "at least 2 each way are needed");
  // The sizes may come from a broken header: no product that overflows.
  const bool fits = size[0] < kNoIndex && size[1] < kNoIndex / size[0] && size[2] < kNoIndex / (size[0] * size[1]);
  if (!fits || size[0] * size[1] * size[2] != points)
    failInput(fmt::format("a grid of {} points comes with {} of them", shape, points), where, "is the file cut short?");
  if (!blank.empty() && blank.size() != points)
    failInput(fmt::format("{} points come with {} blanking values", points, blank.size()), where,
              "is the file cut short?");
}

}  // namespace

TetMesh cutStructuredGrid(Size size, std::vector<Vec3> points, std::vector<int> blank, std::vector<Field> pointFields,
                          std::vector<Field> cellFields, const std::string& where) {
  checkGrid(size, points.size(), blank, where);
  const Size cells = {size[0] - 1, size[1] - 1, size[2] - 1};
  const std::size_t cellCount = cells[0] * cells[1] * cells[2];
  checkFields(pointFields, points.size(), "points", where);
  checkFields(cellFields, cellCount, "cells", where);

  const auto corner = [&](std::size_t cell, int bits) {
    const auto b = static_cast<std::size_t>(bits);
    const std::size_t i = cell % cells[0] + (b & 1);
    const std::size_t j = cell / cells[0] % cells[1] + (b >> 1 & 1);
    const std::size_t k = cell / (cells[0] * cells[1]) + (b >> 2);
    return i + size[0] * (j + size[1] * k);
  };
  const auto isVisible = [&](std::size_t cell) {
    for (int bits = 0; bits < 8; ++bits)
      if (!blank.empty() && blank[corner(cell, bits)] == 0) return false;
    return true;
  };
  needMemory((sizeof(Index) + 5.0 * sizeof(Tetrahedron)) * static_cast<double>(cellCount),
             fmt::format("cutting {} grid cells into tetrahedra", cellCount), where);
  std::vector<Index> kept;
  kept.reserve(cellCount);
  for (std::size_t cell = 0; cell < cellCount; ++cell)
    if (isVisible(cell)) kept.push_back(static_cast<Index>(cell));
  if (kept.empty()) failInput("every cell of the grid is blanked", where, "leave the blanking out");

  TetMesh mesh;
  mesh.sourceCells = kept.size();
  if (kept.size() < cellCount) mesh.notes.push_back(fmt::format("left out {} blanked cells", cellCount - kept.size()));
  mesh.tetrahedra.resize(5 * kept.size());
  parallelFor(0, kept.size(), 1024, [&](std::size_t n) {
    const std::size_t cell = kept[n];
    const std::size_t parity = cell % cells[0] + cell / cells[0] % cells[1] + cell / (cells[0] * cells[1]);
    const auto& pieces = parity % 2 == 0 ? kEven : kOdd;
    for (std::size_t piece = 0; piece < 5; ++piece)
      for (std::size_t v = 0; v < 4; ++v)
        mesh.tetrahedra[5 * n + piece][v] = static_cast<Index>(corner(cell, pieces[piece][v]));
  });
  for (const Field& field : cellFields) {
    const auto components = static_cast<std::size_t>(field.components);
    Field cut{field.name, field.components, std::vector<double>(mesh.tetrahedra.size() * components)};
    parallelFor(0, mesh.tetrahedra.size(), 4096, [&](std::size_t t) {
      std::copy_n(&field.values[kept[t / 5] * components], components, &cut.values[t * components]);
    });
    mesh.cellFields.push_back(std::move(cut));
  }
  mesh.points = std::move(points);
  mesh.pointFields = std::move(pointFields);
  return mesh;
}

}  // namespace havs
