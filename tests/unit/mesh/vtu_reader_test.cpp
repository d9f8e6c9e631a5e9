// The .vtu files that are read without VTK: the same mesh, bit for bit, as VTK's reader gives, whatever their encoding;
// files that are not of that kind, or broken, are left to VTK.
#include "mesh/vtu/vtu_reader.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkIntArray.h>
#include <vtkLongLongArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkStringArray.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLUnstructuredGridWriter.h>

#include <functional>
#include <random>

#include "core/parallel.h"
#include "io_checks.h"
#include "mesh/formats.h"

namespace havs::test {
namespace {

using Writer = vtkXMLUnstructuredGridWriter;

template <class Array, class Attributes>
void addArray(Attributes& attributes, const char* name, vtkIdType tuples, int components,
              const std::function<double()>& value) {
  vtkNew<Array> array;
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(tuples);
  for (vtkIdType i = 0; i < tuples; ++i)
    for (int c = 0; c < components; ++c) array->SetComponent(i, c, value());
  attributes.AddArray(array);
}

/// Random tetrahedra with fields of several types. Numbers enough for several blocks and pieces, in each encoding.
vtkSmartPointer<vtkUnstructuredGrid> tetrahedra(vtkIdType points, vtkIdType cells, int pointType) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> real(-1, 1);
  const auto any = [&] { return real(random); };
  const auto whole = [&] { return std::floor(100 * (1 + real(random))); };
  vtkNew<vtkPoints> places;
  places->SetDataType(pointType);
  for (vtkIdType i = 0; i < points; ++i) places->InsertNextPoint(any(), 1e-200 * any(), 1e20 * any());
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  grid->SetPoints(places);
  std::uniform_int_distribution<vtkIdType> corner(0, points - 1);
  for (vtkIdType i = 0; i < cells; ++i) {
    const vtkIdType corners[4] = {corner(random), corner(random), corner(random), corner(random)};
    grid->InsertNextCell(VTK_TETRA, 4, corners);
  }
  addArray<vtkDoubleArray>(*grid->GetPointData(), "pressure (kPa)", points, 1, any);
  addArray<vtkFloatArray>(*grid->GetPointData(), "velocity", points, 3, any);
  addArray<vtkIntArray>(*grid->GetPointData(), "number", points, 1, whole);
  addArray<vtkUnsignedCharArray>(*grid->GetCellData(), "flag", cells, 1, whole);
  addArray<vtkLongLongArray>(*grid->GetCellData(), "id", cells, 2, whole);
  return grid;
}

void write(
    vtkUnstructuredGrid* grid, const std::filesystem::path& file,
    const std::function<void(Writer&)>& setUp = [](Writer&) {}) {
  vtkNew<Writer> writer;
  writer->SetFileName(file.c_str());
  writer->SetInputData(grid);
  setUp(*writer);
  ASSERT_EQ(writer->Write(), 1) << file;
}

void expectSame(const std::vector<Field>& a, const std::vector<Field>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].name, b[i].name);
    EXPECT_EQ(a[i].components, b[i].components);
    EXPECT_EQ(a[i].values, b[i].values);
  }
}

void expectSame(const TetMesh& a, const TetMesh& b) {
  EXPECT_EQ(a.points, b.points);
  EXPECT_EQ(a.tetrahedra, b.tetrahedra);
  EXPECT_EQ(a.sourceCells, b.sourceCells);
  EXPECT_EQ(a.notes, b.notes);
  expectSame(a.pointFields, b.pointFields);
  expectSame(a.cellFields, b.cellFields);
}

struct VtuEncoding {
  const char* name;
  int mode;
  bool base64;
  int compressor;
};

constexpr VtuEncoding kEncodings[] = {
    {"ascii", Writer::Ascii, false, Writer::NONE},       {"inline", Writer::Binary, true, Writer::NONE},
    {"inline_zlib", Writer::Binary, true, Writer::ZLIB}, {"raw", Writer::Appended, false, Writer::NONE},
    {"raw_zlib", Writer::Appended, false, Writer::ZLIB}, {"raw_lz4", Writer::Appended, false, Writer::LZ4},
    {"base64", Writer::Appended, true, Writer::NONE},    {"base64_zlib", Writer::Appended, true, Writer::ZLIB}};

std::function<void(Writer&)> settingsOf(const VtuEncoding& encoding) {
  return [&encoding](Writer& writer) {
    writer.SetDataMode(encoding.mode);
    writer.SetEncodeAppendedData(encoding.base64);
    writer.SetCompressorType(encoding.compressor);
  };
}

class PlainVtu : public testing::TestWithParam<VtuEncoding> {};

TEST_P(PlainVtu, IsReadAsVtkReadsIt) {
  const Folder folder;
  for (const int pointType : {VTK_FLOAT, VTK_DOUBLE}) {
    const auto grid = tetrahedra(9000, 15000, pointType);
    write(grid, folder / "mesh.vtu", settingsOf(GetParam()));
    const auto mesh = readPlainVtu(folder / "mesh.vtu");
    ASSERT_TRUE(mesh);
    EXPECT_EQ(mesh->tetrahedra.size(), 15000u);
    expectSame(*mesh, readWithVtk(folder / "mesh.vtu", {}));
  }
}

TEST_P(PlainVtu, TypesHeadersBlocksAndThreadsChangeNothing) {
  const Folder folder;
  const auto grid = tetrahedra(3000, 7001, VTK_DOUBLE);
  write(grid, folder / "mesh.vtu", settingsOf(GetParam()));
  const auto expected = readPlainVtu(folder / "mesh.vtu");
  ASSERT_TRUE(expected);
  for (const int idType : {Writer::Int32, Writer::Int64})
    for (const int headerType : {Writer::UInt32, Writer::UInt64})
      for (const std::size_t block : {200, 1000, 32768, 1 << 24}) {
        write(grid, folder / "other.vtu", [&](Writer& writer) {
          settingsOf(GetParam())(writer);
          writer.SetIdType(idType);
          writer.SetHeaderType(headerType);
          writer.SetBlockSize(block);
        });
        const ThreadLimit limit(1 + block % 7);
        const auto other = readPlainVtu(folder / "other.vtu");
        ASSERT_TRUE(other) << idType << ' ' << headerType << ' ' << block;
        expectSame(*other, *expected);
      }
}

/// Whatever is missing at the end: nothing is read from it, or all but the last tags of XML were there.
TEST_P(PlainVtu, CutAnywhereIsNotRead) {
  const Folder folder;
  write(tetrahedra(5, 3, VTK_FLOAT), folder / "mesh.vtu", settingsOf(GetParam()));
  const std::string text = contentOf(folder / "mesh.vtu");
  const ThreadLimit limit(1);  // thousands of tiny files
  const auto whole = readPlainVtu(folder / "mesh.vtu");
  ASSERT_TRUE(whole);
  for (std::size_t length = text.size() - 1; length > 0; --length) {
    std::filesystem::resize_file(folder / "mesh.vtu", length);
    const auto mesh = readPlainVtu(folder / "mesh.vtu");
    if (!mesh) continue;
    ASSERT_GT(length + 40, text.size());
    expectSame(*mesh, *whole);
  }
}

/// In place: a file system may flush a file that is written anew to disk, and there are thousands.
void putByte(const std::filesystem::path& file, std::size_t at, char byte) {
  std::fstream(file, std::ios::binary | std::ios::in | std::ios::out).seekp(static_cast<std::streamoff>(at)).put(byte);
}

/// One byte changed: no crash, and a mesh whose corners exist, or none.
TEST_P(PlainVtu, ChangedAnywhereStaysInBounds) {
  const Folder folder;
  write(tetrahedra(5, 3, VTK_FLOAT), folder / "mesh.vtu", settingsOf(GetParam()));
  const std::string text = contentOf(folder / "mesh.vtu");
  const ThreadLimit limit(1);
  std::mt19937 random(7);
  std::size_t refused = 0;
  for (std::size_t at = 0; at < text.size(); ++at) {
    putByte(folder / "mesh.vtu", at, at % 2 ? static_cast<char>(random()) : "0<>\"= 9/A"[random() % 9]);
    const auto mesh = readPlainVtu(folder / "mesh.vtu");
    putByte(folder / "mesh.vtu", at, text[at]);
    if (!mesh) ++refused;
    if (!mesh) continue;
    for (const Tetrahedron& t : mesh->tetrahedra)
      for (const Index corner : t) ASSERT_LT(corner, mesh->points.size());
    for (const Field& field : mesh->pointFields) ASSERT_EQ(field.tuples(), mesh->points.size());
    for (const Field& field : mesh->cellFields) ASSERT_EQ(field.tuples(), mesh->tetrahedra.size());
  }
  EXPECT_GT(refused, text.size() / 4);
}

INSTANTIATE_TEST_SUITE_P(All, PlainVtu, testing::ValuesIn(kEncodings), [](const auto& row) { return row.param.name; });

TEST(OtherVtu, IsLeftToVtk) {
  const Folder folder;
  const auto refused = [&](
                           vtkUnstructuredGrid* grid, const std::function<void(Writer&)>& setUp = [](Writer&) {}) {
    write(grid, folder / "mesh.vtu", setUp);
    return !readPlainVtu(folder / "mesh.vtu");
  };
  const auto grid = tetrahedra(20, 9, VTK_FLOAT);
  EXPECT_FALSE(refused(grid));
  EXPECT_TRUE(refused(grid, [](Writer& writer) { writer.SetCompressorType(Writer::LZMA); }));
  EXPECT_TRUE(refused(grid, [](Writer& writer) { writer.SetByteOrderToBigEndian(); }));
  EXPECT_TRUE(refused(grid, [](Writer& writer) { writer.SetNumberOfPieces(2); }));

  vtkNew<vtkUnstructuredGrid> labelled;
  labelled->DeepCopy(grid);
  vtkNew<vtkStringArray> labels;
  labels->SetName("label");
  for (int i = 0; i < 20; ++i) labels->InsertNextValue("point");
  labelled->GetPointData()->AddArray(labels);
  EXPECT_TRUE(refused(labelled));

  vtkNew<vtkUnstructuredGrid> ghosts;
  ghosts->DeepCopy(grid);
  ghosts->AllocateCellGhostArray();
  EXPECT_TRUE(refused(ghosts));

  vtkNew<vtkUnstructuredGrid> mixed;
  mixed->DeepCopy(grid);
  const vtkIdType triangle[3] = {0, 1, 2};
  mixed->InsertNextCell(VTK_TRIANGLE, 3, triangle);
  EXPECT_TRUE(refused(mixed));
}

/// Its memory: a promise of two thousand million points is refused before it is taken.
TEST(OtherVtu, PromisesTakeNoMemory) {
  const Folder folder;
  for (const VtuEncoding& encoding : kEncodings) {
    write(tetrahedra(5, 3, VTK_FLOAT), folder / "mesh.vtu", settingsOf(encoding));
    for (const auto& [from, to] : {std::pair("NumberOfPoints=\"5\"", "NumberOfPoints=\"2000000000\""),
                                   std::pair("NumberOfCells=\"3\"", "NumberOfCells=\"4000000000\""),
                                   std::pair("NumberOfComponents=\"3\"", "NumberOfComponents=\"9999\"")}) {
      std::string text = contentOf(folder / "mesh.vtu");
      const std::size_t at = text.find(from);
      ASSERT_NE(at, std::string::npos);
      text.replace(at, std::string(from).size(), to);
      EXPECT_FALSE(readPlainVtu(folder.write("promise.vtu", text))) << encoding.name << ' ' << to;
    }
  }
}

/// As other writers make them: comments, single quotes, no declaration, data of a field, keys inside an array.
TEST(PlainVtuText, OfOtherWriters) {
  const Folder folder;
  const std::string text =
      "<!-- made > by hand -->\n<VTKFile type='UnstructuredGrid' version=\"0.1\" byte_order=\"LittleEndian\">\n"
      "<UnstructuredGrid><FieldData><DataArray type=\"Float64\" Name=\"TimeValue\" NumberOfTuples=\"1\" "
      "format=\"ascii\">3</DataArray></FieldData>\n"
      "<Piece NumberOfCells = '1' NumberOfPoints='4'>\n"
      "<Points><DataArray type=\"Float32\" NumberOfComponents=\"3\" format=\"ascii\">0 0 0 1e0 0 0\n+0 1 0  0 0 0.1"
      "<InformationKey name=\"L2_NORM_RANGE\" location=\"vtkDataArray\" length=\"1\"><Value index=\"0\">7</Value>"
      "</InformationKey></DataArray></Points>\n"
      "<Cells><DataArray type=\"Int32\" Name=\"connectivity\" format=\"ascii\">\n0 1 2 3\n</DataArray>"
      "<DataArray type=\"Int32\" Name=\"offsets\" format=\"ascii\">4</DataArray>"
      "<DataArray type=\"UInt8\" Name=\"types\" format=\"ascii\">10</DataArray></Cells>\n"
      "<PointData><DataArray type=\"Float64\" Name=\"a > b\" format=\"ascii\">1 2\t3\r\n1e-400</DataArray></PointData>"
      "<CellData/></Piece></UnstructuredGrid></VTKFile>\n";
  const auto mesh = readPlainVtu(folder.write("hand.vtu", text));
  ASSERT_TRUE(mesh);
  EXPECT_THAT(mesh->tetrahedra, testing::ElementsAre(Tetrahedron{0, 1, 2, 3}));
  EXPECT_THAT(mesh->points, testing::ElementsAre(Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 0.1f)));
  ASSERT_EQ(mesh->pointFields.size(), 1u);
  EXPECT_EQ(mesh->pointFields[0].name, "a > b");
  EXPECT_THAT(mesh->pointFields[0].values, testing::ElementsAre(1, 2, 3, 0));
}

}  // namespace
}  // namespace havs::test
