// Headers that promise what is not there, or more than any machine holds.
#include <fstream>

#include "hard/hostile.h"
#include "support/png_bytes.h"

namespace havs::test {
namespace {

class HostileHeaders : public HostileTest {
 protected:
  void writeVtu(const std::string& name, const std::string& points, const std::string& cells) {
    folder.write(name,
                 "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" "
                 "header_type=\"UInt64\"><UnstructuredGrid><Piece NumberOfPoints=\"" +
                     points + "\" NumberOfCells=\"" + cells + R"("><Points>
<DataArray type="Float64" NumberOfComponents="3" format="ascii">0 0 0 1 0 0 0 1 0 0 0 1</DataArray></Points><Cells>
<DataArray type="Int64" Name="connectivity" format="ascii">0 1 2 3</DataArray>
<DataArray type="Int64" Name="offsets" format="ascii">4</DataArray>
<DataArray type="UInt8" Name="types" format="ascii">10</DataArray></Cells></Piece></UnstructuredGrid></VTKFile>)");
  }
  /// A scanline file whose data window has this last pixel.
  std::string exrOf(std::int32_t last) {
    const auto four = [](std::uint32_t n) { return std::string(reinterpret_cast<const char*>(&n), 4); };
    const auto attribute = [&](const std::string& name, const std::string& type, const std::string& value) {
      return name + '\0' + type + '\0' + four(static_cast<std::uint32_t>(value.size())) + value;
    };
    std::string channels;
    for (const char* name : {"B", "G", "R"})
      channels += name + std::string(1, '\0') + four(2) + four(0) + four(1) + four(1);
    const std::string window =
        four(0) + four(0) + four(static_cast<std::uint32_t>(last)) + four(static_cast<std::uint32_t>(last));
    const std::string one("\0\0\x80\x3f", 4);
    return four(20000630) + four(2) + attribute("channels", "chlist", channels + '\0') +
           attribute("compression", "compression", std::string(1, '\3')) + attribute("dataWindow", "box2i", window) +
           attribute("displayWindow", "box2i", window) + attribute("lineOrder", "lineOrder", std::string(1, '\0')) +
           attribute("pixelAspectRatio", "float", one) + attribute("screenWindowCenter", "v2f", four(0) + four(0)) +
           attribute("screenWindowWidth", "float", one) + '\0' + std::string(64, '\0');
  }
};

TEST_F(HostileHeaders, TrillionPointsInAFewLines) {
  tell("a reader that makes room for a header's 10^12 points or cells asks for 24 TB",
       "a count is held against the bytes that the rest of the file has before memory is taken");
  writeTetgenMesh(folder, "points", "1000000000000 3 0 0\n0 0 0 0\n", kCubeEle);
  writeTetgenMesh(folder, "cells", kCubeNode, "1000000000000 4 0\n0 0 1 2 3\n");
  folder.write("mesh.inp", "1 1000000000000 0 0 0\n1 0 0 0\n");
  expectRefused({"info", "points.node"}, "points.node:1: 1000000000000 points are promised");
  expectRefused({"info", "cells.ele"}, "cells.ele:1: 1000000000000 tetrahedra are promised");
  expectRefused({"info", "mesh.inp"}, "mesh.inp:1: 1000000000000 cells are promised");
}

TEST_F(HostileHeaders, CountsBeyond64Bits) {
  tell(
      "2^64 wraps to 0 where a parser does not look, and count times columns wraps too: room for few, then all is read",
      "numbers that do not fit are none, and products are compared by division or in double");
  writeTetgenMesh(folder, "points", "18446744073709551616 3 0 0\n0 0 0 0\n", kCubeEle);
  writeTetgenMesh(folder, "cells", kCubeNode, "4611686018427387904 4 9999\n0 0 1 2 3\n");
  folder.write("surface.off", "OFF\n9223372036854775807 18446744073709551615 0\n");
  folder.write("surface.poly", "9223372036854775807 3 0 0\n0 0 0 0\n");
  expectRefused({"info", "points.node"}, "points.node:1");
  expectRefused({"info", "cells.ele"}, "cells.ele:1");
#if HAVS_WITH_TETGEN
  expectRefused({"info", "surface.off"}, "surface.off:2");
  expectRefused({"info", "surface.poly"}, "surface.poly:1");
#endif
}

TEST_F(HostileHeaders, NegativeCounts) {
  tell("-1 made unsigned is 2^64 - 1", "a negative count is an error that names the line");
  writeTetgenMesh(folder, "points", "-4 3 0 0\n", kCubeEle);
  writeTetgenMesh(folder, "columns", "4 3 -1 0\n0 0 0 0\n1 1 0 0\n2 0 1 0\n3 0 0 1\n", kCubeEle);
  folder.write("mesh.inp", "4 -1 0 0 0\n1 0 0 0\n");
  expectRefused({"info", "points.node"}, "points.node:1");
  expectRefused({"info", "columns.node"}, "columns.node:1");
  expectRefused({"info", "mesh.inp"}, "mesh.inp:1");
}

TEST_F(HostileHeaders, PicturesOfATrillionPixels) {
  tell("a picture of 10^6 x 10^6 pixels is 16 TB, and PNG and OpenEXR may say so in 100 bytes",
       "no more pixels are believed than the file's bytes can unpack to (1,100 of one at most)");
  folder.write("a.pfm", "PF\n1000000 1000000\n-1.0\n");
  folder.write("a.png", pngBytes(1000000, 1000000, std::string(1, '\0')));
  folder.write("b.png", pngBytes(0x7fffffff, 0x7fffffff, std::string(1, '\0')));
  folder.write("a.exr", exrOf(999999));
  folder.write("b.exr", exrOf(0x7fffffff));
  for (const char* name : {"a.pfm", "a.png", "b.png", "a.exr", "b.exr"}) expectRefused({"compare", name, name}, name);
}

#if HAVS_WITH_TETGEN
TEST_F(HostileHeaders, QuintillionVerticesOfASurface) {
  tell("PLY's and STL's binary headers hold counts of up to 64 bits",
       "the count is held against the bytes that follow, also where elements take no bytes");
  const std::string ply =
      "ply\nformat binary_little_endian 1.0\nelement vertex 1000000000000000000\n"
      "property float x\nproperty float y\nproperty float z\nend_header\n";
  folder.write("a.ply", ply + std::string(24, '\0'));
  folder.write("b.ply", "ply\nformat ascii 1.0\nelement nothing 1000000000000000000\nelement vertex 0\nend_header\n");
  folder.write("a.stl", std::string(80, ' ') + "\xff\xff\xff\xff" + std::string(100, '\0'));
  expectRefused({"info", "a.ply"}, "a.ply");
  expectRefused({"info", "b.ply"}, "b.ply");
  expectRefused({"info", "a.stl"}, "a.stl");
}
#endif

#if HAVS_WITH_VTK
TEST_F(HostileHeaders, TrillionPointsInXml) {
  tell("VTK's reader makes room for what NumberOfPoints says, and dies where that is 10^12",
       "the fast reader passes such a file on; VTK reads it in a child process whose memory has a limit");
  writeVtu("points.vtu", "1000000000000", "1");
  writeVtu("cells.vtu", "4", "1000000000000");
  writeVtu("negative.vtu", "-4", "1");
  writeVtu("wrapped.vtu", "18446744073709551617", "1");
  for (const char* name : {"points.vtu", "cells.vtu", "negative.vtu", "wrapped.vtu"})
    expectRefused({"info", name, "--max-memory", "600M"}, name, 600);
}

TEST_F(HostileHeaders, GridOfATrillionPointsWithoutData) {
  tell("an image grid's points need not be in the file: an extent of 10,000^3 in one line is 100 TB of tetrahedra",
       "the grid's size is held against --max-memory, else the machine's memory, before it is cut");
  folder.write("grid.vti",
               "<VTKFile type=\"ImageData\" version=\"1.0\" byte_order=\"LittleEndian\"><ImageData WholeExtent=\"0 "
               "9999 0 9999 0 9999\" Origin=\"0 0 0\" Spacing=\"1 1 1\"><Piece Extent=\"0 9999 0 9999 0 9999\">"
               "</Piece></ImageData></VTKFile>");
  folder.write("small.vti",
               "<VTKFile type=\"ImageData\" version=\"1.0\" byte_order=\"LittleEndian\"><ImageData WholeExtent=\"0 "
               "399 0 399 0 399\" Origin=\"0 0 0\" Spacing=\"1 1 1\"><Piece Extent=\"0 399 0 399 0 399\">"
               "</Piece></ImageData></VTKFile>");
  expectRefused({"info", "grid.vti"}, "grid.vti", 300);
  expectRefused({"info", "small.vti", "--max-memory", "1G"}, "small.vti", 300);
}
#endif

}  // namespace
}  // namespace havs::test
