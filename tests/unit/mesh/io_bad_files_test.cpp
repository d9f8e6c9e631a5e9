// Broken files of the VTK family: each is refused by one clear line, whatever VTK's reader does with it.
#include "io_checks.h"

namespace havs::test {
namespace {

std::string legacy(const std::string& rest) { return "# vtk DataFile Version 3.0\ntest\nASCII\nDATASET " + rest; }

std::string oneCell(const std::string& cell, const std::string& type) {
  return legacy("UNSTRUCTURED_GRID\nPOINTS 4 float\n0 0 0 1 0 0 0 1 0 0 0 1\nCELLS 1 5\n" + cell + "\nCELL_TYPES 1\n" +
                type + "\n");
}

std::string image(const std::string& extent) {
  return "<?xml version=\"1.0\"?><VTKFile type=\"ImageData\" version=\"0.1\"><ImageData WholeExtent=\"" + extent +
         "\" Origin=\"0 0 0\" Spacing=\"1 1 1\"><Piece Extent=\"" + extent + "\"></Piece></ImageData></VTKFile>";
}

struct BadFile {
  const char* name;
  std::string content;
  const char* part;  ///< of the message
};

class BadVtkFiles : public testing::TestWithParam<BadFile> {};

TEST_P(BadVtkFiles, AreRefusedByOneLine) {
  const Folder folder;
  expectRefused(folder.write(GetParam().name, GetParam().content), GetParam().part);
}

const std::string kNoise = [] {
  std::string bytes(5000, '\0');
  unsigned state = 1;
  for (char& byte : bytes) byte = static_cast<char>((state = state * 1664525u + 1013904223u) >> 24);
  return bytes;
}();

INSTANTIATE_TEST_SUITE_P(
    All, BadVtkFiles,
    testing::Values(
        BadFile{"text.vtu", "hello\n", "cannot be read"}, BadFile{"text.vtk", "hello\n", "cannot be read"},
        BadFile{"noise.vtu", kNoise, "cannot be read"}, BadFile{"noise.ex2", kNoise, "cannot be read"},
        BadFile{"noise.cgns", kNoise, "is the file whole?"}, BadFile{"text.case", "hello\n", "cannot be read"},
        BadFile{"surface.vtk", legacy("POLYDATA\nPOINTS 3 float\n0 0 0 1 0 0 0 1 0\nPOLYGONS 1 4\n3 0 1 2\n"),
                "vtkPolyData"},
        BadFile{"triangle.vtk", oneCell("3 0 1 2 ", "5"), ""}, BadFile{"range.vtk", oneCell("4 0 1 2 99", "10"), "99"},
        BadFile{"negative.vtk", oneCell("4 0 1 2 -7", "10"), "-7"}, BadFile{"word.vtk", oneCell("4 0 1 x 3", "10"), ""},
        BadFile{"nocells.vtk", legacy("UNSTRUCTURED_GRID\nPOINTS 4 float\n0 0 0 1 0 0 0 1 0 0 0 1\n"),
                "no three-dimensional"},
        BadFile{"lie.vtk", legacy("UNSTRUCTURED_GRID\nPOINTS 2000000000 float\n0 0 0\n"), ""},
        BadFile{"huge.vtk",
                legacy("STRUCTURED_POINTS\nDIMENSIONS 100000 100000 100000\nORIGIN 0 0 0\nSPACING 1 1 1\n"
                       "POINT_DATA 1000000000000000\nSCALARS s double 1\nLOOKUP_TABLE default\n1 2 3\n"),
                "cannot be read"},
        BadFile{"huge.vti", image("0 100000 0 100000 0 100000"), "points"},
        BadFile{"flat.vti", image("0 5 0 5 0 0"), "no three-dimensional"},
        BadFile{"cut.vtu", "<?xml version=\"1.0\"?><VTKFile type=\"UnstructuredGrid\"><UnstructuredGrid><Piece",
                "cannot be read"}),
    [](const auto& row) {
      std::string name = row.param.name;
      std::ranges::replace(name, '.', '_');
      return name;
    });

TEST(TruncatedRealFiles, AreRefused) {
  for (const char* name : {"mfem_bracket_appended_compressed.vtu", "tetraMesh.vtk", "box-noglom.ex2"}) {
    const std::filesystem::path file = std::filesystem::path(HAVS_SHARED_DATA) / name;
    if (!std::filesystem::exists(file)) GTEST_SKIP() << "no real meshes beside the repository: " << file;
    const Folder folder;
    const std::string whole = contentOf(file);
    expectRefused(folder.write(name, whole.substr(0, whole.size() / 2)), "is the file whole");
  }
}

}  // namespace
}  // namespace havs::test
