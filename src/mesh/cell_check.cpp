#include "mesh/cell_check.h"

#include <fmt/format.h>

#include <atomic>
#include <span>

#include "core/error.h"
#include "core/parallel.h"
#include "mesh/cell_shapes.h"

namespace havs {
namespace {

using Numbers = std::span<const std::int64_t>;

/// Checks what all cells share; afterwards each cell's range of `connectivity` exists.
void checkArrays(const CellSoup& cells, const std::string& where) {
  if (cells.points.size() >= kNoIndex)
    failInput(fmt::format("{} points are more than can be numbered", cells.points.size()), where, "split the mesh");
  checkFields(cells.pointFields, cells.points.size(), "points", where);
  checkFields(cells.cellFields, cells.types.size(), "cells", where);
  if (cells.types.empty()) failInput("there are no cells", where, "a volume needs tetrahedra or other solid cells");
  if (cells.offsets.size() != cells.types.size() + 1 || cells.offsets.front() != 0 ||
      cells.offsets.back() > static_cast<std::int64_t>(cells.connectivity.size()))
    failInput(fmt::format("the offsets of the {} cells do not fit the {} point numbers", cells.types.size(),
                          cells.connectivity.size()),
              where, "is the file cut short?");
  for (std::size_t i = 0; i < cells.types.size(); ++i)
    if (cells.offsets[i + 1] < cells.offsets[i])
      failInput(fmt::format("cell {} ends before it begins", i), where, "the offsets must not fall");
}

bool exists(std::int64_t point, std::size_t pointCount) {
  return point >= 0 && point < static_cast<std::int64_t>(pointCount);
}

/// Whether `stream` is VTK's face stream: number of faces, then for each face its number of points and the points.
bool isFaceStream(Numbers stream, std::size_t pointCount) {
  if (stream.empty() || stream[0] < 4) return false;
  std::size_t at = 1;
  for (std::int64_t face = 0; face < stream[0]; ++face) {
    if (at >= stream.size() || stream[at] < 3 || stream[at] > static_cast<std::int64_t>(stream.size() - at - 1))
      return false;
    const auto n = static_cast<std::size_t>(stream[at]);
    for (std::size_t i = 1; i <= n; ++i)
      if (!exists(stream[at + i], pointCount)) return false;
    at += n + 1;
  }
  return at == stream.size();
}

bool isSound(const CellSoup& cells, std::size_t cell) {
  const CellShape& shape = cellShape(cells.types[cell]);
  if (!shape.name || shape.rule == CutRule::unsupported) return false;
  if (shape.rule == CutRule::leaveOut) return true;
  const auto begin = static_cast<std::size_t>(cells.offsets[cell]);
  const Numbers numbers(cells.connectivity.data() + begin, static_cast<std::size_t>(cells.offsets[cell + 1]) - begin);
  if (shape.rule == CutRule::polyhedron) return isFaceStream(numbers, cells.points.size());
  if (numbers.size() != shape.pointCount) return false;
  for (const std::int64_t point : numbers)
    if (!exists(point, cells.points.size())) return false;
  return true;
}

[[noreturn]] void explain(const CellSoup& cells, std::size_t cell, const std::string& where) {
  const CellShape& shape = cellShape(cells.types[cell]);
  const auto begin = static_cast<std::size_t>(cells.offsets[cell]);
  const auto end = static_cast<std::size_t>(cells.offsets[cell + 1]);
  if (!shape.name)
    failInput(fmt::format("cell {} has the unknown type {}", cell, cells.types[cell]), where,
              "the types are VTK's, 10 a tetrahedron");
  if (shape.rule == CutRule::unsupported)
    failInput(fmt::format("cell {} is of type {} ({}), which is not read", cell, cells.types[cell], shape.name), where,
              "write linear or quadratic cells");
  if (shape.rule != CutRule::polyhedron) {
    if (end - begin != shape.pointCount)
      failInput(fmt::format("cell {} has {} points, but {} have {}", cell, end - begin, shape.name, shape.pointCount),
                where, "is the file cut short?");
    for (std::size_t i = begin; i < end; ++i)
      if (!exists(cells.connectivity[i], cells.points.size()))
        failInput(fmt::format("cell {} has the point number {}, out of range for {} points", cell,
                              cells.connectivity[i], cells.points.size()),
                  where, "points are numbered from 0 here");
  }
  failInput(fmt::format("cell {} is a polyhedron whose list of faces is broken: fewer than four faces, a face of fewer "
                        "than three points, a point number out of range for {} points, or a wrong length",
                        cell, cells.points.size()),
            where, "write the mesh again, or leave that cell out");
}

}  // namespace

void checkFields(const std::vector<Field>& fields, std::size_t wanted, const char* what, const std::string& where) {
  for (const Field& field : fields)
    if (field.components < 1 || field.values.size() != wanted * static_cast<std::size_t>(field.components))
      failInput(fmt::format("the field '{}' has {} values of {} components for {} {}", field.name, field.values.size(),
                            field.components, wanted, what),
                where, "is the file cut short?");
}

void checkCells(const CellSoup& cells, const std::string& where) {
  checkArrays(cells, where);
  std::atomic<std::size_t> firstBroken = cells.types.size();
  parallelFor(0, cells.types.size(), 4096, [&](std::size_t cell) {
    if (isSound(cells, cell)) return;
    std::size_t known = firstBroken;
    while (cell < known && !firstBroken.compare_exchange_weak(known, cell)) {
    }
  });
  if (firstBroken < cells.types.size()) explain(cells, firstBroken, where);
}

}  // namespace havs
