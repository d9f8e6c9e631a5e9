// PLOT3D files of every binary kind that is told apart by its size, and of text.
#include <bit>
#include <cstring>
#include <sstream>

#include "io_checks.h"

namespace havs::test {
namespace {

constexpr int kSize[3] = {3, 4, 5};
constexpr std::size_t kPoints = 3 * 4 * 5;
constexpr std::size_t kCells = 2 * 3 * 4;

struct Kind {
  const char* name;
  bool bigEndian = false, multiGrid = false, iblank = false, byteCounts = false, doubles = false;
};

/// Writes numbers as the kind says, records with byte counts around them for Fortran's.
class RecordWriter {
 public:
  explicit RecordWriter(const Kind& kind) : kind_(kind) {}
  void integer(int value) { bytes(record_, value); }
  void real(double value) { kind_.doubles ? bytes(record_, value) : bytes(record_, static_cast<float>(value)); }
  void endRecord() {
    const auto size = static_cast<int>(record_.size());
    if (kind_.byteCounts) bytes(file_, size);
    file_ += record_;
    if (kind_.byteCounts) bytes(file_, size);
    record_.clear();
  }
  const std::string& file() const { return file_; }

 private:
  template <class T>
  void bytes(std::string& to, T value) {
    char raw[sizeof(T)];
    std::memcpy(raw, &value, sizeof(T));
    if (kind_.bigEndian != (std::endian::native == std::endian::big)) std::reverse(raw, raw + sizeof(T));
    to.append(raw, sizeof(T));
  }
  const Kind& kind_;
  std::string record_, file_;
};

Vec3 position(std::size_t i) {
  return {static_cast<double>(i % 3), static_cast<double>(i / 3 % 4), static_cast<double>(i / 12)};
}
double density(const Vec3& p) { return 1 + p.x + 2 * p.y + 4 * p.z; }

void header(RecordWriter& out, const Kind& kind) {
  if (kind.multiGrid) {
    out.integer(1);
    out.endRecord();
  }
  for (const int n : kSize) out.integer(n);
  out.endRecord();
}

std::string gridFile(const Kind& kind) {
  RecordWriter out(kind);
  header(out, kind);
  for (int axis = 0; axis < 3; ++axis)
    for (std::size_t i = 0; i < kPoints; ++i) out.real(position(i)[axis]);
  if (kind.iblank)
    for (std::size_t i = 0; i < kPoints; ++i) out.integer(i == 0 ? 0 : 1);  // a corner: one cell
  out.endRecord();
  return out.file();
}

std::string solutionFile(const Kind& kind) {
  RecordWriter out(kind);
  header(out, kind);
  for (const double condition : {0.5, 0.0, 1e5, 0.0}) out.real(condition);
  out.endRecord();
  for (int variable = 0; variable < 5; ++variable)
    for (std::size_t i = 0; i < kPoints; ++i)
      out.real(variable == 0 ? density(position(i)) : variable == 4 ? 50 : 0.25);
  out.endRecord();
  return out.file();
}

class Plot3dKinds : public testing::TestWithParam<Kind> {};

TEST_P(Plot3dKinds, AreToldApart) {
  const Kind& kind = GetParam();
  const Folder folder;
  const auto grid = folder.write("boxxyz.bin", gridFile(kind));
  folder.write("boxq.bin", solutionFile(kind));
  const TetMesh mesh = readMesh(grid);
  EXPECT_EQ(mesh.points.size(), kPoints);
  EXPECT_EQ(mesh.tetrahedra.size(), 5 * (kind.iblank ? kCells - 1 : kCells));
  EXPECT_NEAR(volume(mesh), static_cast<double>(kind.iblank ? kCells - 1 : kCells), 1e-12);  // unit cells
  expectPointField(mesh, "Density", density, 0);                                             // small integers
  for (const char* name : {"Momentum", "Velocity"}) {
    ASSERT_NE(find(mesh.pointFields, name), nullptr) << name;
    EXPECT_EQ(find(mesh.pointFields, name)->components, 3) << name;
  }
  expectPointField(
      mesh, "StagnationEnergy", [](const Vec3&) { return 50; }, 0);
  ASSERT_NE(find(mesh.pointFields, "Pressure"), nullptr);
}

INSTANTIATE_TEST_SUITE_P(All, Plot3dKinds,
                         testing::Values(Kind{.name = "little"}, Kind{.name = "big", .bigEndian = true},
                                         Kind{.name = "multi_grid", .multiGrid = true},
                                         Kind{.name = "iblank", .bigEndian = true, .multiGrid = true, .iblank = true},
                                         Kind{.name = "fortran", .bigEndian = true, .byteCounts = true},
                                         Kind{.name = "doubles", .doubles = true}),
                         [](const auto& row) { return row.param.name; });

TEST(Plot3d, TheSolutionMayBeNamed) {
  const Kind kind{.name = "little"};
  const Folder folder;
  const auto grid = folder.write("grid.xyz", gridFile(kind));
  const auto solution = folder.write("other.dat", solutionFile(kind));
  EXPECT_THAT(readMesh(grid).notes, testing::Contains(testing::HasSubstr("no PLOT3D q file")));
  EXPECT_TRUE(readMesh(grid).pointFields.empty());
  expectPointField(readMesh(grid, {.plot3dSolution = solution}), "Density", density, 0);
  EXPECT_THROW(readMesh(grid, {.plot3dSolution = folder / "missing.q"}), Error);
}

TEST(Plot3d, NamingTheSolutionFindsTheGrid) {
  const Kind kind{.name = "little"};
  const Folder folder;
  folder.write("boxxyz.bin", gridFile(kind));
  expectPointField(readMesh(folder.write("boxq.bin", solutionFile(kind))), "Density", density, 0);
}

TEST(Plot3d, BrokenFilesAreRefused) {
  const Kind kind{.name = "little"};
  const std::string grid = gridFile(kind), solution = solutionFile(kind);
  const Folder folder;
  expectRefused(folder.write("shortxyz.bin", grid.substr(0, grid.size() / 2)), "cannot be read");
  expectRefused(folder.write("words.xyz", "no grid at all\n"), "cannot be read");
  folder.write("halfq.bin", solution.substr(0, solution.size() / 2));
  expectRefused(folder.write("halfxyz.bin", grid), "cannot be read");
  expectRefused(folder.write("aloneq.bin", solution), "without its grid");
}

}  // namespace
}  // namespace havs::test
