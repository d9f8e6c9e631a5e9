#include "mesh/vtk/module/vtu_file.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkErrorCode.h>
#include <vtkIdTypeArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLUnstructuredGridWriter.h>

#include <algorithm>
#include <stdexcept>

namespace havs {
namespace {

vtkSmartPointer<vtkDoubleArray> copyOf(const double* values, std::size_t tuples, int components) {
  auto array = vtkSmartPointer<vtkDoubleArray>::New();
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(static_cast<vtkIdType>(tuples));
  std::copy_n(values, tuples * static_cast<std::size_t>(components), array->GetPointer(0));
  return array;
}

void addFields(const std::vector<Field>& fields, vtkDataSetAttributes& attributes) {
  for (const Field& field : fields) {
    const auto array = copyOf(field.values.data(), field.tuples(), field.components);
    array->SetName(field.name.c_str());
    attributes.AddArray(array);
  }
}

vtkSmartPointer<vtkCellArray> cellsOf(const std::vector<Tetrahedron>& tetrahedra) {
  vtkNew<vtkIdTypeArray> corners;
  corners->SetNumberOfValues(static_cast<vtkIdType>(4 * tetrahedra.size()));
  vtkIdType* corner = corners->GetPointer(0);
  for (const Tetrahedron& tetrahedron : tetrahedra) corner = std::ranges::copy(tetrahedron, corner).out;
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  cells->SetData(4, corners);
  return cells;
}

}  // namespace

void writeVtuFile(const TetMesh& mesh, const char* file) {
  static_assert(sizeof(Vec3) == 3 * sizeof(double));
  vtkNew<vtkPoints> points;
  points->SetData(copyOf(mesh.points.empty() ? nullptr : &mesh.points[0].x, mesh.points.size(), 3));
  vtkNew<vtkUnstructuredGrid> grid;
  grid->SetPoints(points);
  grid->SetCells(VTK_TETRA, cellsOf(mesh.tetrahedra));
  addFields(mesh.pointFields, *grid->GetPointData());
  addFields(mesh.cellFields, *grid->GetCellData());

  vtkNew<vtkXMLUnstructuredGridWriter> writer;
  writer->SetFileName(file);
  writer->SetInputData(grid);
  writer->SetDataModeToAppended();
  writer->EncodeAppendedDataOff();
  writer->SetCompressorTypeToZLib();
  if (!writer->Write() || writer->GetErrorCode() != vtkErrorCode::NoError)
    throw std::runtime_error(vtkErrorCode::GetStringFromErrorCode(writer->GetErrorCode()));
}

}  // namespace havs
