// Numbers as files hold them: integers, single precision, text.
#include <cmath>

#include "hard/like_plain.h"
#include "hard/mesh_text.h"
#include "mesh/read.h"
#include "support/temporary_folder.h"

namespace havs::test {
namespace {

constexpr const char* kGroup = "Scale and place";

/// What numbers of points and of the field are written as: VTK's names, and those of its older format.
struct Types {
  const char* xml;
  const char* legacy;
  double largest;  ///< that all integers up to it are numbers of the type; 0: not an integer
};

constexpr Types kIntegers[] = {{"Int8", "char", 127},
                               {"UInt8", "unsigned_char", 255},
                               {"Int16", "short", 32767},
                               {"UInt16", "unsigned_short", 65535},
                               {"Int32", "int", 2147483647},
                               {"UInt32", "unsigned_int", 4294967295},
                               {"Int64", "vtktypeint64", 0x1p53},
                               {"UInt64", "vtktypeuint64", 0x1p53}};

std::string numbersOf(const std::vector<double>& values) { return fmt::format("{}\n", fmt::join(values, " ")); }

std::string placesOf(const TetMesh& mesh) {
  std::string text;
  for (const Vec3& p : mesh.points) text += fmt::format("{} {} {}\n", p.x, p.y, p.z);
  return text;
}

std::string vtuOf(const TetMesh& mesh, const char* pointType, const char* fieldType) {
  std::string cells, offsets, types;
  for (std::size_t i = 0; i < mesh.tetrahedra.size(); ++i) {
    cells += fmt::format("{}\n", fmt::join(mesh.tetrahedra[i], " "));
    offsets += fmt::format("{} ", 4 * (i + 1));
    types += "10 ";
  }
  const auto array = [](const char* type, const char* name, int components, const std::string& numbers) {
    return fmt::format(
        "<DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\" format=\"ascii\">\n{}</DataArray>\n", type, name,
        components, numbers);
  };
  return fmt::format(
      "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\">\n<UnstructuredGrid>\n"
      "<Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">\n<Points>\n{}</Points>\n<Cells>\n{}{}{}</Cells>\n"
      "<PointData>\n{}</PointData>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n",
      mesh.points.size(), mesh.tetrahedra.size(), array(pointType, "Points", 3, placesOf(mesh)),
      array("Int64", "connectivity", 1, cells), array("Int64", "offsets", 1, offsets),
      array("UInt8", "types", 1, types), array(fieldType, "s", 1, numbersOf(mesh.pointFields[0].values)));
}

std::string legacyOf(const TetMesh& mesh, const char* pointType, const char* fieldType) {
  std::string cells, types;
  for (const auto& cell : mesh.tetrahedra) {
    cells += fmt::format("4 {}\n", fmt::join(cell, " "));
    types += "10\n";
  }
  const std::size_t n = mesh.tetrahedra.size();
  return fmt::format(
      "# vtk DataFile Version 3.0\nmesh\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS {0} {1}\n{2}CELLS {3} {4}\n{5}"
      "CELL_TYPES {3}\n{6}POINT_DATA {0}\nSCALARS s {7} 1\nLOOKUP_TABLE default\n{8}",
      mesh.points.size(), pointType, placesOf(mesh), n, 5 * n, cells, types, fieldType,
      numbersOf(mesh.pointFields[0].values));
}

class NumberTypes : public LikePlainTest {
 protected:
  TetMesh read(const std::string& name, const std::string& content) { return readMesh(folder_.write(name, content)); }
  TemporaryFolder folder_;
};

/// The field in whole numbers that reach up to `largest`.
TetMesh wholeNumbers(double largest) {
  return mapped(
      plainMesh(3), [](const Vec3& p) { return p; }, [&](double v) { return std::round(v * largest); });
}

TEST_F(NumberTypes, IntegerFieldsOfVtu) {
  tell({kGroup, "fields of 8 to 64 bits, read as float, lose digits from 2^24 on",
        "every type is read into double; up to 2^53 nothing is lost, and pictures are those of the same numbers in "
        "memory, bit for bit"});
  for (const Types& type : kIntegers) {
    SCOPED_TRACE(type.xml);
    Scene scene = plainScene();
    scene.domain = {0, type.largest};
    const TetMesh mesh = wholeNumbers(type.largest);
    const HardPicture plain = expectEveryWay(scene, mesh);
    expectLike(plain, expectEveryWay(scene, read("a.vtu", vtuOf(mesh, "Float64", type.xml))), 0);
  }
}

#if HAVS_WITH_VTK
TEST_F(NumberTypes, IntegerFieldsOfLegacyVtk) {
  tell({kGroup, "fields of 8 to 64 bits, read as float, lose digits from 2^24 on",
        "every type is read into double; pictures are those of the same numbers in memory, bit for bit"});
  for (const Types& type : kIntegers) {
    SCOPED_TRACE(type.legacy);
    Scene scene = plainScene();
    scene.domain = {0, type.largest};
    const TetMesh mesh = wholeNumbers(type.largest);
    const HardPicture plain = expectEveryWay(scene, mesh);
    expectLike(plain, expectEveryWay(scene, read("a.vtk", legacyOf(mesh, "double", type.legacy))), 0);
  }
}
#endif

/// Volatile: where it converts two numbers at once, GCC 12.2 leaves out the way to float and back.
double single(double v) {
  const volatile float rounded = static_cast<float>(v);
  return rounded;
}

TEST_F(NumberTypes, SinglePrecisionFiles) {
  tell({kGroup, "points and fields in single precision carry 24 bits",
        "they are drawn as the numbers that they are; the picture is that of the same numbers in double, bit for bit"});
  const TetMesh mesh = mapped(
      plainMesh(3), [&](const Vec3& p) { return Vec3(single(p.x), single(p.y), single(p.z)); }, single);
  const HardPicture plain = expectEveryWay(plainScene(), mesh);
  expectLike(plain, expectEveryWay(plainScene(), read("a.vtu", vtuOf(mesh, "Float32", "Float32"))), 0);
#if HAVS_WITH_VTK
  expectLike(plain, expectEveryWay(plainScene(), read("a.vtk", legacyOf(mesh, "float", "float"))), 0);
#endif
}

TEST_F(NumberTypes, TextAtTheEndsOfDouble) {
  tell({kGroup, "text of 1e-290 or 1e300 in .node files, read as float, is 0 or infinite",
        "numbers are read as doubles, to the last bit"});
  const HardPicture plain = expectEveryWay(plainScene(), plainMesh(3));
  for (const Units& units : {Units{.length = 1e-290, .scalar = 1e300}, Units{.length = 1e300, .scalar = 1e-290}}) {
    const TetMesh mesh = meshIn(units, plainMesh(3));
    expectLike(plain, expectEveryWay(sceneIn(units, plainScene()), readMesh(writeNodeEle(folder_, "a", mesh))),
               kSameInAnyUnit);
  }
}

}  // namespace
}  // namespace havs::test
