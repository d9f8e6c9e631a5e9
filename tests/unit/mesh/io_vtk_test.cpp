// Every encoding of the VTK formats, on files that VTK's own writers make from a box with a linear field.
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkImageData.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkRectilinearGrid.h>
#include <vtkStringArray.h>
#include <vtkStructuredGrid.h>
#include <vtkStructuredGridWriter.h>
#include <vtkStructuredPointsWriter.h>
#include <vtkUnstructuredGrid.h>
#include <vtkUnstructuredGridWriter.h>
#include <vtkXMLImageDataWriter.h>
#include <vtkXMLRectilinearGridWriter.h>
#include <vtkXMLStructuredGridWriter.h>
#include <vtkXMLUnstructuredGridWriter.h>

#include <cstdlib>
#include <functional>

#include "io_checks.h"

namespace havs::test {
namespace {

constexpr int kSize[3] = {3, 4, 5};        // points along each axis
constexpr std::size_t kCells = 2 * 3 * 4;  // of the grid
constexpr double kSpacing[3] = {0.5, 1, 2};
constexpr double kVolume = 1.0 * 3.0 * 8.0;  // of the box
constexpr double kRounding = 1e-12;          // sums of a few hundred numbers near 1 in double
constexpr double kFloatRounding = 1e-6;      // ASCII writers print about 7 digits

double linear(const Vec3& p) { return 1 + p.x + 2 * p.y + 3 * p.z; }

/// Adds the linear field, a vector, cell numbers and an array of text.
void addFields(vtkDataSet& data) {
  vtkNew<vtkDoubleArray> scalars, vectors;
  vtkNew<vtkIntArray> numbers;
  vtkNew<vtkStringArray> names;
  scalars->SetName("linear");
  vectors->SetName("position");
  vectors->SetNumberOfComponents(3);
  numbers->SetName("number");
  names->SetName("label");
  for (vtkIdType i = 0; i < data.GetNumberOfPoints(); ++i) {
    Vec3 p;
    data.GetPoint(i, &p.x);
    scalars->InsertNextValue(linear(p));
    vectors->InsertNextTuple(&p.x);
    names->InsertNextValue("point");
  }
  for (int i = 0; i < data.GetNumberOfCells(); ++i) numbers->InsertNextValue(i);
  data.GetPointData()->AddArray(scalars);
  data.GetPointData()->AddArray(vectors);
  data.GetPointData()->AddArray(names);
  data.GetCellData()->AddArray(numbers);
}

vtkSmartPointer<vtkImageData> image() {
  auto data = vtkSmartPointer<vtkImageData>::New();
  data->SetDimensions(kSize);
  data->SetSpacing(kSpacing);
  addFields(*data);
  return data;
}

vtkSmartPointer<vtkStructuredGrid> curvilinear() {
  const auto source = image();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (vtkIdType i = 0; i < source->GetNumberOfPoints(); ++i) points->InsertNextPoint(source->GetPoint(i));
  auto data = vtkSmartPointer<vtkStructuredGrid>::New();
  data->SetDimensions(kSize);
  data->SetPoints(points);
  addFields(*data);
  return data;
}

vtkSmartPointer<vtkRectilinearGrid> rectilinear() {
  auto data = vtkSmartPointer<vtkRectilinearGrid>::New();
  data->SetDimensions(kSize);
  vtkNew<vtkDoubleArray> axes[3];
  for (int axis = 0; axis < 3; ++axis)
    for (int i = 0; i < kSize[axis]; ++i) axes[axis]->InsertNextValue(i * kSpacing[axis]);
  data->SetXCoordinates(axes[0]);
  data->SetYCoordinates(axes[1]);
  data->SetZCoordinates(axes[2]);
  addFields(*data);
  return data;
}

/// The same box as hexahedra.
vtkSmartPointer<vtkUnstructuredGrid> hexahedra() {
  const auto source = curvilinear();
  auto data = vtkSmartPointer<vtkUnstructuredGrid>::New();
  data->SetPoints(source->GetPoints());
  for (vtkIdType i = 0; i < source->GetNumberOfCells(); ++i)
    data->InsertNextCell(VTK_HEXAHEDRON, 8, source->GetCell(i)->GetPointIds()->GetPointer(0));
  addFields(*data);
  return data;
}

template <class Writer>
void write(
    vtkDataObject* data, const std::filesystem::path& file,
    const std::function<void(Writer&)>& setUp = [](Writer&) {}) {
  vtkNew<Writer> writer;
  writer->SetFileName(file.c_str());
  writer->SetInputData(data);
  setUp(*writer);
  ASSERT_EQ(writer->Write(), 1) << file;
}

void expectBox(const TetMesh& mesh, double tolerance) {
  EXPECT_EQ(mesh.points.size(), 3u * 4 * 5);
  EXPECT_EQ(mesh.sourceCells, kCells);
  EXPECT_NEAR(volume(mesh), kVolume, kVolume * tolerance);
  expectPointField(mesh, "linear", linear, 30 * tolerance);  // its largest value
  const Field* position = find(mesh.pointFields, "position");
  ASSERT_NE(position, nullptr);
  EXPECT_EQ(position->components, 3);
  const Field* number = find(mesh.cellFields, "number");
  ASSERT_NE(number, nullptr);
  EXPECT_EQ(number->tuples(), mesh.tetrahedra.size());
  EXPECT_EQ(*std::ranges::max_element(number->values), kCells - 1);
  EXPECT_EQ(find(mesh.pointFields, "label"), nullptr);
  EXPECT_THAT(mesh.notes, testing::Contains(testing::HasSubstr("'label'")));
}

struct Encoding {
  const char* name;
  int mode;
  bool base64;
  int compressor;
};

class VtuEncodings : public testing::TestWithParam<Encoding> {};

TEST_P(VtuEncodings, HoldsTheSameBox) {
  const Folder folder;
  const Encoding& encoding = GetParam();
  write<vtkXMLUnstructuredGridWriter>(hexahedra(), folder / "box.vtu", [&](vtkXMLUnstructuredGridWriter& writer) {
    writer.SetDataMode(encoding.mode);
    writer.SetEncodeAppendedData(encoding.base64);
    writer.SetCompressorType(encoding.compressor);
  });
  expectBox(readMesh(folder / "box.vtu"), kRounding);
}

INSTANTIATE_TEST_SUITE_P(All, VtuEncodings,
                         testing::Values(Encoding{"ascii", vtkXMLWriter::Ascii, false, vtkXMLWriter::NONE},
                                         Encoding{"binary", vtkXMLWriter::Binary, true, vtkXMLWriter::NONE},
                                         Encoding{"binary_zlib", vtkXMLWriter::Binary, true, vtkXMLWriter::ZLIB},
                                         Encoding{"raw", vtkXMLWriter::Appended, false, vtkXMLWriter::NONE},
                                         Encoding{"raw_zlib", vtkXMLWriter::Appended, false, vtkXMLWriter::ZLIB},
                                         Encoding{"raw_lz4", vtkXMLWriter::Appended, false, vtkXMLWriter::LZ4},
                                         Encoding{"raw_lzma", vtkXMLWriter::Appended, false, vtkXMLWriter::LZMA},
                                         Encoding{"base64", vtkXMLWriter::Appended, true, vtkXMLWriter::NONE},
                                         Encoding{"base64_zlib", vtkXMLWriter::Appended, true, vtkXMLWriter::ZLIB}),
                         [](const auto& row) { return row.param.name; });

TEST(VtkStructured, EveryKindBecomesFiveTetrahedraACell) {
  const Folder folder;
  write<vtkXMLImageDataWriter>(image(), folder / "box.vti");
  write<vtkXMLRectilinearGridWriter>(rectilinear(), folder / "box.vtr");
  write<vtkXMLStructuredGridWriter>(curvilinear(), folder / "box.vts");
  for (const char* name : {"box.vti", "box.vtr", "box.vts"}) {
    SCOPED_TRACE(name);
    const TetMesh mesh = readMesh(folder / name);
    expectBox(mesh, kRounding);
    EXPECT_EQ(mesh.tetrahedra.size(), 5 * kCells);
  }
}

TEST(VtkLegacy, TextAndBinary) {
  const Folder folder;
  for (const int type : {VTK_ASCII, VTK_BINARY}) {
    const double tolerance = type == VTK_ASCII ? kFloatRounding : kRounding;
    const auto setType = [&](auto& writer) { writer.SetFileType(type); };
    write<vtkUnstructuredGridWriter>(hexahedra(), folder / "cells.vtk", setType);
    write<vtkStructuredGridWriter>(curvilinear(), folder / "grid.vtk", setType);
    write<vtkStructuredPointsWriter>(image(), folder / "image.vtk", setType);
    for (const char* name : {"cells.vtk", "grid.vtk", "image.vtk"}) {
      SCOPED_TRACE(name);
      expectBox(readMesh(folder / name), tolerance);
    }
  }
}

TEST(VtkStructured, BlankedCellsAreLeftOut) {
  const Folder folder;
  const auto grid = curvilinear();
  grid->BlankCell(0);
  grid->BlankCell(7);
  write<vtkXMLStructuredGridWriter>(grid, folder / "box.vts");
  const TetMesh mesh = readMesh(folder / "box.vts");
  EXPECT_EQ(mesh.sourceCells, kCells - 2);
  EXPECT_EQ(mesh.tetrahedra.size(), 5 * (kCells - 2));
  EXPECT_NEAR(volume(mesh), kVolume * (kCells - 2) / kCells, kVolume * kRounding);
  EXPECT_EQ(std::ranges::count(find(mesh.cellFields, "number")->values, 7), 0);
  EXPECT_EQ(mesh.cellFields.size(), 1u);
}

TEST(VtkStructured, BlankedPointsTakeTheirCellsAlong) {
  const Folder folder;
  const auto grid = curvilinear();
  grid->BlankPoint(0);  // a corner: one cell
  write<vtkXMLStructuredGridWriter>(grid, folder / "box.vts");
  EXPECT_EQ(readMesh(folder / "box.vts").sourceCells, kCells - 1);
}

TEST(VtkStructured, FlatGridsAreRefused) {
  const Folder folder;
  vtkNew<vtkImageData> flat;
  flat->SetDimensions(5, 1, 5);
  write<vtkXMLImageDataWriter>(flat, folder / "flat.vti");
  expectRefused(folder / "flat.vti", "no three-dimensional cells");
}

TEST(VtuWriter, RoundTripKeepsEveryBit) {
  const Folder folder;
  write<vtkXMLUnstructuredGridWriter>(hexahedra(), folder / "box.vtu");
  const TetMesh first = readMesh(folder / "box.vtu");
  writeMesh(first, folder / "again.vtu");
  const TetMesh second = readMesh(folder / "again.vtu");
  EXPECT_EQ(first.points, second.points);
  EXPECT_EQ(first.tetrahedra, second.tetrahedra);
  ASSERT_EQ(first.pointFields.size(), second.pointFields.size());
  for (std::size_t i = 0; i < first.pointFields.size(); ++i) {
    EXPECT_EQ(first.pointFields[i].name, second.pointFields[i].name);
    EXPECT_EQ(first.pointFields[i].components, second.pointFields[i].components);
    EXPECT_EQ(first.pointFields[i].values, second.pointFields[i].values);
  }
  ASSERT_EQ(second.cellFields.size(), 1u);
  EXPECT_EQ(first.cellFields[0].values, second.cellFields[0].values);
  EXPECT_THAT(contentOf(folder / "again.vtu"), testing::HasSubstr("vtkZLibDataCompressor"));
}

TEST(VtuWriter, LeavesNothingBehindWhereItCannotWrite) {
  const TetMesh mesh{.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, .tetrahedra = {{0, 1, 2, 3}}};
  const Folder folder;
  EXPECT_THROW(writeMesh(mesh, folder / "missing" / "out.vtu"), Error);
  EXPECT_FALSE(std::filesystem::exists(folder / "missing"));
}

TEST(VtkModule, SaysWhenItIsMissing) {
  const Folder folder;
  write<vtkXMLImageDataWriter>(image(), folder / "box.vti");
  setenv("HAVS_MODULES", (folder / "nowhere").c_str(), 1);
  try {
    readMesh(folder / "box.vti");
    ADD_FAILURE() << "read without a module";
  } catch (const Error& error) {
    EXPECT_EQ(error.exitStatus(), 1);
    EXPECT_THAT(error.what(), testing::HasSubstr("HAVS_MODULES"));
  }
  unsetenv("HAVS_MODULES");
}

}  // namespace
}  // namespace havs::test
