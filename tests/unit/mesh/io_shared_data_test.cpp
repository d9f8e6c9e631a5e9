// Real meshes: the counts that their sources state, and their fields.
#include "io_checks.h"

namespace havs::test {
namespace {

struct RealMesh {
  const char* file;
  std::size_t points;  ///< 0: not stated
  std::size_t cells, tetrahedra;
  const char* pointField;
  const char* cellField;
};

class RealMeshes : public testing::TestWithParam<RealMesh> {};

TEST_P(RealMeshes, HaveTheirCountsAndFields) {
  const RealMesh& real = GetParam();
  const std::filesystem::path file = std::filesystem::path(HAVS_SHARED_DATA) / real.file;
  if (!std::filesystem::exists(file)) GTEST_SKIP() << "no real meshes beside the repository: " << file;
  const TetMesh mesh = readMesh(file);
  if (real.points > 0) {
    EXPECT_EQ(mesh.points.size(), real.points);
  }
  EXPECT_EQ(mesh.sourceCells, real.cells);
  if (real.tetrahedra > 0) {
    EXPECT_EQ(mesh.tetrahedra.size(), real.tetrahedra);
  }
  if (real.pointField) {
    EXPECT_NE(find(mesh.pointFields, real.pointField), nullptr);
  }
  if (real.cellField) {
    EXPECT_NE(find(mesh.cellFields, real.cellField), nullptr);
  }
  for (const Field& field : mesh.pointFields) EXPECT_EQ(field.tuples(), mesh.points.size()) << field.name;
  for (const Field& field : mesh.cellFields) EXPECT_EQ(field.tuples(), mesh.tetrahedra.size()) << field.name;
}

INSTANTIATE_TEST_SUITE_P(
    All, RealMeshes,
    testing::Values(RealMesh{"bluntfinxyz.bin", 40960, 37479, 187395, "Density", nullptr},
                    RealMesh{"fea_bracket_kiefer.vtu", 0, 56786, 454288, nullptr,
                             "Equivalent (von-Mises) Stress (psi)"},
                    RealMesh{"svfsi_pipe_rigid_wall_flow.vtu", 0, 170694, 170694, "Pressure", nullptr},
                    RealMesh{"mfem_bracket_appended_compressed.vtu", 0, 206208, 206208, "xdsp", "sj2p"},
                    RealMesh{"blood_vessels/T0000000500.pvtu", 0, 39353, 0, "node_value", "density"},
                    RealMesh{"notch_disp.vtu", 0, 2192, 0, "Nodal Displacement", nullptr},
                    RealMesh{"tetraMesh.vtk", 55, 160, 160, "scalars", nullptr},
                    RealMesh{"box-noglom.ex2", 27, 40, 40, "First Point Array", "Fourth Cell Array"}),
    [](const auto& row) {
      std::string name = std::filesystem::path(row.param.file).stem().string();
      std::ranges::replace_if(
          name, [](unsigned char c) { return !std::isalnum(c); }, '_');
      return name;
    });

}  // namespace
}  // namespace havs::test
