// The real meshes: read with the counts that are known of them, and drawn.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "cli/run_havs.h"
#include "image/image.h"

namespace havs::test {
namespace {

namespace fs = std::filesystem;

class SharedData : public testing::Test {
 protected:
  void SetUp() override {
    if (!fs::is_directory(HAVS_SHARED_DATA)) GTEST_SKIP() << "no real meshes at " << HAVS_SHARED_DATA;
  }
  /// All but .inp are read through VTK.
  static bool isReadable(const fs::path& name) { return HAVS_WITH_VTK || name.extension() == ".inp"; }
  static std::string file(const std::string& name) { return (fs::path(HAVS_SHARED_DATA) / name).string(); }
  nlohmann::json infoOf(const std::string& name) {
    const Outcome run = runHavs({"info", file(name), "--json"}, folder.path());
    EXPECT_EQ(run.status, 0) << run.error;
    return nlohmann::json::parse(run.output);
  }
  TemporaryFolder folder;
};

/// The counts of the paper's tables.
TEST_F(SharedData, BluntFinHasTheCountsOfThePaper) {
  if (!isReadable("bluntfinxyz.bin")) GTEST_SKIP() << "this build has no VTK";
  const auto info = infoOf("bluntfinxyz.bin");
  EXPECT_EQ(info["points"], 40960);
  EXPECT_EQ(info["tetrahedra"], 187395);
}

TEST_F(SharedData, SpxHasTheCountsOfThePaper) {
  const auto info = infoOf("spx.inp");
  EXPECT_EQ(info["points"], 2896);
  EXPECT_EQ(info["tetrahedra"], 12936);
}

class DrawnData : public SharedData, public testing::WithParamInterface<const char*> {};

TEST_P(DrawnData, FillsAPartOfThePicture) {
  if (!fs::exists(file(GetParam()))) GTEST_SKIP() << "no " << GetParam();
  if (!isReadable(GetParam())) GTEST_SKIP() << "this build has no VTK";
  const Outcome run = runHavs(
      {"render", file(GetParam()), "-o", "a.exr", "--size", "64x64", "--table", "16", "--quiet"}, folder.path());
  ASSERT_EQ(run.status, 0) << run.error;
  const Image image = readImage(folder / "a.exr");
  int seen = 0;
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x) seen += image.pixel(x, y)[3] > 0.001f;
  EXPECT_GT(seen,
            64 * 64 / 100);  // the bounding sphere fits the picture: even a thin part covers one pixel in a hundred
  EXPECT_LT(seen, 64 * 64);  // and leaves its corners empty
}

INSTANTIATE_TEST_SUITE_P(AllMeshes, DrawnData,
                         testing::Values("bluntfinxyz.bin", "spx.inp", "fea_bracket_kiefer.vtu", "notch_disp.vtu",
                                         "mfem_bracket_appended_compressed.vtu", "svfsi_pipe_rigid_wall_flow.vtu",
                                         "tetraMesh.vtk", "box-noglom.ex2", "blood_vessels/T0000000500.pvtu"));

}  // namespace
}  // namespace havs::test
