// What unpacks to, or asks for, more memory than there is: refused before it is taken.
#include <lz4.h>

#include "core/error.h"
#include "core/memory_budget.h"
#include "hard/hostile.h"
#include "support/meshes.h"
#include "support/png_bytes.h"
#include "support/resident_memory.h"

namespace havs::test {
namespace {

class HostileMemory : public HostileTest {
 protected:
  ~HostileMemory() override { limitMemory(0); }
};

template <class Number>
std::string bytesOf(std::initializer_list<Number> numbers) {
  return {reinterpret_cast<const char*>(numbers.begin()), numbers.size() * sizeof(Number)};
}

std::string lz4Bytes(const std::string& bytes) {
  std::string packed(static_cast<std::size_t>(LZ4_compressBound(static_cast<int>(bytes.size()))), '\0');
  packed.resize(static_cast<std::size_t>(LZ4_compress_default(
      bytes.data(), packed.data(), static_cast<int>(bytes.size()), static_cast<int>(packed.size()))));
  return packed;
}

/// The largest blocks, all of zeros: 20,000,000 points at the origin, 480 MB, and a cell that names the first ones.
std::string zipBomb(const std::string& compressor, int cellType) {
  using Size = std::uint64_t;
  constexpr Size kPoints = 20000000, kBlock = 1 << 20;
  const auto packed = [&](const std::string& bytes) {
    return compressor == "vtkLZ4DataCompressor" ? lz4Bytes(bytes) : zlibBytes(bytes);
  };
  const auto array = [&](Size bytes, const std::string& block, const std::string& last) {
    const Size whole = bytes / kBlock, rest = bytes % kBlock;
    std::string header = bytesOf<Size>({whole + (rest > 0 ? 1 : 0), kBlock, rest}), data;
    for (Size i = 0; i < whole; ++i) header += bytesOf<Size>({block.size()}), data += block;
    if (rest > 0) header += bytesOf<Size>({last.size()}), data += last;
    return header + data;
  };
  const auto small = [&](const std::string& bytes) { return array(bytes.size(), "", packed(bytes)); };
  const Size bytes = 3 * sizeof(double) * kPoints;
  const int corners = cellType == 10 ? 4 : 8;
  std::string appended = array(bytes, packed(std::string(kBlock, '\0')), packed(std::string(bytes % kBlock, '\0')));
  std::vector<std::size_t> offsets{0, appended.size()};
  appended += small(bytesOf<std::int32_t>({0, 1, 2, 3, 4, 5, 6, 7}).substr(0, 4 * static_cast<std::size_t>(corners)));
  offsets.push_back(appended.size());
  appended += small(bytesOf<std::int32_t>({corners}));
  offsets.push_back(appended.size());
  appended += small(std::string(1, static_cast<char>(cellType)));
  const auto at = [&](std::size_t i) { return " format=\"appended\" offset=\"" + std::to_string(offsets[i]) + "\"/>"; };
  return "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\" "
         "compressor=\"" +
         compressor + "\"><UnstructuredGrid><Piece NumberOfPoints=\"" + std::to_string(kPoints) +
         "\" NumberOfCells=\"1\"><Points><DataArray type=\"Float64\" NumberOfComponents=\"3\"" + at(0) +
         "</Points><Cells><DataArray type=\"Int32\" Name=\"connectivity\"" + at(1) +
         "<DataArray type=\"Int32\" Name=\"offsets\"" + at(2) + "<DataArray type=\"UInt8\" Name=\"types\"" + at(3) +
         "</Cells></Piece></UnstructuredGrid><AppendedData encoding=\"raw\">_" + appended + "</AppendedData></VTKFile>";
}

#if HAVS_WITH_VTK
TEST_F(HostileMemory, ZipBombs) {
  tell("zlib packs a thousand zeros into one byte, LZ4 250: a file of 0.5 MB becomes 480 MB of points",
       "an array's unpacked size is held against --max-memory, else the machine's, before a block of it is unpacked");
  for (const char* compressor : {"vtkZLibDataCompressor", "vtkLZ4DataCompressor"}) {
    folder.write("bomb.vtu", zipBomb(compressor, 10));
    expectRefused({"info", "bomb.vtu", "--max-memory", "200M"},
                  "bomb.vtu: 20000000 points needs 458 MB of memory, but --max-memory is 200 MB", 100);
  }
}

TEST_F(HostileMemory, ZipBombsInVtksReader) {
  if (kSanitized) GTEST_SKIP() << "no limit of memory under sanitizers";
  tell("what the fast reader does not read, hexahedra for one, VTK unpacks and knows no limit",
       "it runs in a child process that may take no more than the limit, and says that it needs more");
  for (const char* compressor : {"vtkZLibDataCompressor", "vtkLZ4DataCompressor"}) {
    folder.write("bomb.vtu", zipBomb(compressor, 12));
    expectRefused({"info", "bomb.vtu", "--max-memory", "300M"}, "bomb.vtu", 300);
  }
}

TEST_F(HostileMemory, Base64Garbage) {
  tell("a decoder that takes every byte as six bits makes points of garbage",
       "bytes outside the alphabet end the array, and the file is refused");
  folder.write("garbage.vtu",
               "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\"><UnstructuredGrid>"
               "<Piece NumberOfPoints=\"4\" NumberOfCells=\"1\"><Points><DataArray type=\"Float64\" "
               "NumberOfComponents=\"3\" format=\"binary\">" +
                   std::string(200, '!') +
                   "</DataArray></Points><Cells><DataArray type=\"Int64\" Name=\"connectivity\" format=\"binary\">"
                   "\xff\xfe====</DataArray><DataArray type=\"Int64\" Name=\"offsets\" "
                   "format=\"binary\">CAAAAAQAAAAAAAAA</DataArray>"
                   "<DataArray type=\"UInt8\" Name=\"types\" "
                   "format=\"binary\">AQAAAAo=</DataArray></Cells></Piece></UnstructuredGrid></VTKFile>");
  expectRefused({"info", "garbage.vtu"}, "garbage.vtu", 300);
}
#endif

TEST_F(HostileMemory, SparseFilesOfTerabytes) {
  tell(
      "a file of a terabyte without a byte on disk was read until memory ended: bad_alloc, or the system killed the "
      "program",
      "the file's own size is held against the memory first");
  for (const char* name : {"a.node", "a.inp", "a.exr"}) {
    folder.write(name, "");
    std::filesystem::resize_file(folder / name, std::uintmax_t{1} << 40);
  }
  folder.write("a.ele", kCubeEle);
  expectRefused({"info", "a.node"}, "a.node: its text needs 1.0 TB of memory");
  expectRefused({"info", "a.inp"}, "a.inp: its text needs 1.0 TB of memory");
  expectRefused({"compare", "a.exr", "a.exr"}, "a.exr: the file needs 1.0 TB of memory");
#if HAVS_WITH_TETGEN
  for (const char* name : {"a.ply", "a.stl"}) {
    folder.write(name, "");
    std::filesystem::resize_file(folder / name, std::uintmax_t{1} << 40);
    expectRefused({"info", name}, "the file needs 1.0 TB of memory");
  }
#endif
}

TEST_F(HostileMemory, PicturesBeyondTheLimit) {
  tell("2^30 pixels, the most, are 16 GB; 1,000 views of a scene each keep a picture until all are drawn",
       "width and height have limits, and the pictures of all views are held against the memory before anything is "
       "read");
  expectRefused({"render", "cube.node", "-o", "a.png", "--size", "1000000000x1000000000"},
                "the picture's width is 1000000000");
  expectRefused({"render", "cube.node", "-o", "a.png", "--size", "32768x32768", "--max-memory", "1G"},
                "--size: a picture of 32768 x 32768 needs 16 GB of memory, but --max-memory is 1.0 GB");
  expectRefused({"render", "cube.node", "-o", "a.png", "--size", "8192x8192", "--visibility", "abuffer", "--device",
                 "osmesa", "--max-memory", "500M"},
                "needs 1.0 GB");
  std::string views;
  for (int i = 0; i < 1000; ++i) views += (i > 0 ? "," : "") + ("{\"outputs\":[\"" + std::to_string(i)) + ".png\"]}";
  folder.write("scene.json",
               R"({"version":1,"mesh":"cube.node","size":[1024,1024],"max_memory":"4G","views":[)" + views + "]}");
  expectRefused({"render", "scene.json"}, "views: the 1000 pictures needs 16 GB of memory");
}

TEST_F(HostileMemory, TablesBeyondTheLimit) {
  tell("a table of n^3 grows fast: 2048^3 entries are 128 GB, 512^3 2 GB",
       "512 is the largest; the plan's tables and targets are added up and held against the memory before they are "
       "made");
  expectRefused({"render", "cube.node", "-o", "a.png", "--size", "8x8", "--lookup", "3d", "--table", "2048"}, "2048");
  expectRefused({"render", "cube.node", "-o", "a.png", "--size", "8x8", "--lookup", "3d", "--table", "512",
                 "--max-memory", "500M"},
                "drawing needs 2.0 GB of memory, but --max-memory is 500 MB");
}

TEST_F(HostileMemory, AMillionThreads) {
  tell(
      "oneTBB starts as many threads as it is told: with --threads 1000000000 the program was starting them after a "
      "minute",
      "1,024 are the most; more is refused before anything is read");
  expectRefused({"render", "cube.node", "-o", "a.png", "--size", "8x8", "--threads", "1000000000"},
                "is no number of threads");
  folder.write("scene.json", R"({"version":1,"mesh":"cube.node","threads":18446744073709551615})");
  expectRefused({"render", "scene.json", "-o", "a.png", "--size", "8x8"}, "threads");
}

TEST_F(HostileMemory, AmountsThatAreNone) {
  tell("'8 GB', '-1G' or '1e400G' read as a number and a rest, or wrapped, would be some limit",
       "an amount is a positive number and a unit, below 2^62 bytes");
  for (const char* amount : {"lots", "0", "-1G", "1e400G", "8 GB", "8GiBs", "nan", "99999999T"})
    expectRefused({"info", "cube.node", std::string("--max-memory=") + amount}, "is no amount of memory");
  expectRead({"info", "cube.node", "--quiet", "--max-memory", "0.5g"});
}

#if HAVS_WITH_TETGEN
TEST_F(HostileMemory, TetGenWithoutEnd) {
  if (kSanitized) GTEST_SKIP() << "no limit of memory under sanitizers";
  tell("tetrahedra of 10^-12 in a cube: TetGen goes on until memory ends",
       "it runs in a child process that may take no more than the limit");
  folder.write("cube.poly", kCubePoly);
  const HostileRun run = havs({"info", "cube.poly", "--tetgen", "pqa1e-12", "--max-memory", "150M"});
  EXPECT_EQ(run.status, 1) << run.error;
  EXPECT_THAT(run.error, testing::HasSubstr("allow larger tetrahedra"));
  expectAtMost("memory, MB", run.megabytes, 200);
}
#endif

TEST_F(HostileMemory, MeshesThatReadingLeavesNoRoomFor) {
  tell("a mesh that fits may not fit together with its faces, neighbours and order, 140 bytes a tetrahedron more",
       "they are held against the memory before they are made");
  TetMesh mesh = box(24, Cut::five);
  mesh.pointFields = {Field{"s", 1, constantField(mesh.points, 0.5)}};
  const double needed = 140.0 * static_cast<double>(mesh.tetrahedra.size());
  limitMemory(residentBytes() + static_cast<std::size_t>(needed / 2));
  StageTimes stages;
  std::string why;
  try {
    prepareScene(hardScene(), mesh, stages);
  } catch (const Error& error) {
    why = error.what();
  }
  EXPECT_THAT(why, testing::HasSubstr("tetrahedra ready to be drawn needs 9.2 MB of memory"));
  limitMemory(0);
  resetPeak();
  const std::size_t before = residentBytes();
  prepareScene(hardScene(), std::move(mesh), stages);
  if (!kSanitized)
    expectAtMost("memory taken, of what is foreseen", static_cast<double>(peakResidentBytes() - before) / needed, 1);
  expectAtMost("scenes made ready beyond the limit", why.empty() ? 1 : 0, 0);
}

}  // namespace
}  // namespace havs::test
