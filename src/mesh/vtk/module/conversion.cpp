#include "mesh/vtk/module/conversion.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCompositeDataIterator.h>
#include <vtkCompositeDataSet.h>
#include <vtkDataSet.h>
#include <vtkIdList.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkRectilinearGrid.h>
#include <vtkStructuredGrid.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>

#include <stdexcept>

#include "mesh/vtk/module/fields.h"

namespace havs {
namespace {

constexpr std::size_t kMostPoints = kNoIndex;  // point numbers are 32 bits wide

std::size_t checkedPoints(vtkIdType points) {
  if (points < 0 || static_cast<std::size_t>(points) >= kMostPoints)
    throw std::runtime_error("it has " + std::to_string(points) + " points, more than can be numbered");
  return static_cast<std::size_t>(points);
}

/// A grid's size is a claim of its header alone, as its points need not be in the file.
void checkMemory(std::size_t points, const GridSink& sink) {
  constexpr double kBytesEach = 24 + 5 * 16;  // a point and the tetrahedra of its cell
  const double needed = kBytesEach * static_cast<double>(points);
  if (needed > static_cast<double>(sink.memoryLimit()))
    throw std::runtime_error("its " + std::to_string(points) + " grid points become more tetrahedra than memory holds");
}

std::vector<Vec3> pointsOf(vtkDataSet& data) {
  std::vector<Vec3> points(checkedPoints(data.GetNumberOfPoints()));
  for (std::size_t i = 0; i < points.size(); ++i) data.GetPoint(static_cast<vtkIdType>(i), &points[i].x);
  return points;
}

/// 1 where a flag of the ghost array is among `flags`; empty when there is no ghost array or no such flag.
std::vector<std::uint8_t> flagged(vtkUnsignedCharArray* ghosts, std::size_t count, unsigned flags) {
  if (!ghosts || static_cast<std::size_t>(ghosts->GetNumberOfValues()) != count) return {};
  std::vector<std::uint8_t> result(count);
  bool any = false;
  for (std::size_t i = 0; i < count; ++i) {
    result[i] = (ghosts->GetValue(static_cast<vtkIdType>(i)) & flags) != 0;
    any |= result[i] != 0;
  }
  return any ? result : std::vector<std::uint8_t>{};
}

std::vector<std::uint8_t> hiddenCells(vtkDataSet& data) {
  constexpr unsigned kFlags =
      vtkDataSetAttributes::DUPLICATECELL | vtkDataSetAttributes::HIDDENCELL | vtkDataSetAttributes::REFINEDCELL;
  return flagged(data.GetCellGhostArray(), static_cast<std::size_t>(data.GetNumberOfCells()), kFlags);
}

void noteLeftOut(const std::vector<std::uint8_t>& hidden, GridSink& sink) {
  std::size_t count = 0;
  for (const std::uint8_t flag : hidden) count += flag;
  if (count > 0) sink.note("left out " + std::to_string(count) + " ghost or blanked cells");
}

void dropTuples(const std::vector<std::uint8_t>& hidden, Field& field) {
  const auto components = static_cast<std::size_t>(field.components);
  std::size_t to = 0;
  for (std::size_t from = 0; from < hidden.size(); ++from) {
    if (hidden[from]) continue;
    for (std::size_t c = 0; c < components; ++c) field.values[to++] = field.values[from * components + c];
  }
  field.values.resize(to);
}

/// Cell by cell, for a polyhedron its stream of faces.
void appendCells(vtkUnstructuredGrid& grid, const std::vector<std::uint8_t>& hidden, CellSoup& soup) {
  const vtkIdType count = grid.GetNumberOfCells();
  soup.types.reserve(static_cast<std::size_t>(count));
  soup.offsets.reserve(static_cast<std::size_t>(count) + 1);
  soup.connectivity.reserve(
      static_cast<std::size_t>(grid.GetCells() ? grid.GetCells()->GetNumberOfConnectivityIds() : 0));
  soup.offsets.push_back(0);
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < count; ++cell) {
    if (!hidden.empty() && hidden[static_cast<std::size_t>(cell)]) continue;
    const int type = grid.GetCellType(cell);
    if (type == VTK_POLYHEDRON)
      grid.GetFaceStream(cell, ids);
    else
      grid.GetCellPoints(cell, ids);
    soup.types.push_back(static_cast<std::uint8_t>(type));
    soup.connectivity.insert(soup.connectivity.end(), ids->begin(), ids->end());
    soup.offsets.push_back(static_cast<std::int64_t>(soup.connectivity.size()));
  }
}

void convertCells(vtkUnstructuredGrid& grid, GridSink& sink) {
  CellSoup soup;
  soup.points = pointsOf(grid);
  const std::vector<std::uint8_t> hidden = hiddenCells(grid);
  appendCells(grid, hidden, soup);
  soup.pointFields = fieldsOf(*grid.GetPointData(), soup.points.size(), "point", sink);
  soup.cellFields = fieldsOf(*grid.GetCellData(), static_cast<std::size_t>(grid.GetNumberOfCells()), "cell", sink);
  if (!hidden.empty())
    for (Field& field : soup.cellFields) dropTuples(hidden, field);
  noteLeftOut(hidden, sink);
  sink.add(std::move(soup));
}

/// Of points the blanked ones; a duplicate of another piece's point is none.
std::vector<int> blankOf(vtkDataSet& data) {
  const auto hidden = flagged(data.GetPointGhostArray(), static_cast<std::size_t>(data.GetNumberOfPoints()),
                              vtkDataSetAttributes::HIDDENPOINT);
  std::vector<int> blank(hidden.size());
  for (std::size_t i = 0; i < hidden.size(); ++i) blank[i] = hidden[i] ? 0 : 1;
  return blank;
}

/// Returns false, and adds nothing, when the grid has no volume.
template <class Grid>
bool convertStructured(Grid& grid, GridSink& sink) {
  int size[3];
  grid.GetDimensions(size);
  StructuredBlock block;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (size[axis] < 2) return false;
    block.size[axis] = static_cast<std::size_t>(size[axis]);
  }
  checkMemory(checkedPoints(grid.GetNumberOfPoints()), sink);
  block.points = pointsOf(grid);
  block.blank = blankOf(grid);
  block.hiddenCell = hiddenCells(grid);
  block.pointFields = fieldsOf(*grid.GetPointData(), block.points.size(), "point", sink);
  block.cellFields = fieldsOf(*grid.GetCellData(), static_cast<std::size_t>(grid.GetNumberOfCells()), "cell", sink);
  noteLeftOut(block.hiddenCell, sink);
  sink.add(std::move(block));
  return true;
}

/// Returns false when `data` is of a kind that has no volume.
bool convertBlock(vtkDataObject& data, GridSink& sink) {
  if (auto* cells = vtkUnstructuredGrid::SafeDownCast(&data)) {
    if (cells->GetNumberOfCells() == 0) return false;
    convertCells(*cells, sink);
    return true;
  }
  if (auto* curvilinear = vtkStructuredGrid::SafeDownCast(&data)) return convertStructured(*curvilinear, sink);
  if (auto* rectilinear = vtkRectilinearGrid::SafeDownCast(&data)) return convertStructured(*rectilinear, sink);
  if (auto* image = vtkImageData::SafeDownCast(&data)) return convertStructured(*image, sink);
  return false;
}

std::string describe(vtkDataObject& data) {
  std::string text = "VTK reads it as " + std::string(data.GetClassName());
  if (auto* set = vtkDataSet::SafeDownCast(&data))
    text += " with " + std::to_string(set->GetNumberOfPoints()) + " points and " +
            std::to_string(set->GetNumberOfCells()) + " cells";
  return text;
}

void convertAll(vtkCompositeDataSet& blocks, GridSink& sink) {
  const auto iterator = vtkSmartPointer<vtkCompositeDataIterator>::Take(blocks.NewIterator());
  std::size_t converted = 0, leftOut = 0;
  for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
    ++(convertBlock(*iterator->GetCurrentDataObject(), sink) ? converted : leftOut);
  if (converted == 0)
    throw std::runtime_error("none of its " + std::to_string(leftOut) + " blocks has three-dimensional cells");
  if (leftOut > 0) sink.note("left out " + std::to_string(leftOut) + " blocks without three-dimensional cells");
}

}  // namespace

void convert(vtkDataObject& data, GridSink& sink) {
  if (auto* blocks = vtkCompositeDataSet::SafeDownCast(&data)) return convertAll(*blocks, sink);
  if (!convertBlock(data, sink)) throw std::runtime_error("it has no three-dimensional cells: " + describe(data));
}

}  // namespace havs
