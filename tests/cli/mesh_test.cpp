#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "cli/run_havs.h"
#include "cli/sample_files.h"

namespace havs::test {
namespace {

class Mesh : public testing::Test {
 protected:
  void mesh(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "mesh");
    const Outcome run = runHavs(arguments, folder.path());
    EXPECT_EQ(run.status, 0) << run.error;
    EXPECT_EQ(run.error, "");
  }
  nlohmann::json infoOf(const std::string& name) {
    const Outcome run = runHavs({"info", name, "--json"}, folder.path());
    EXPECT_EQ(run.status, 0) << run.error;
    return nlohmann::json::parse(run.output);
  }
  nlohmann::json rangeOf(const nlohmann::json& info, const std::string& field) {
    for (const auto& row : info["fields"])
      if (row["name"] == field) return row["range"];
    return nullptr;
  }
  TemporaryFolder folder;
};

TEST_F(Mesh, ConvertsAndAddsAField) {
  writeTetgenMesh(folder, "cube", kCubeNode, kCubeEle);
  mesh({"cube.node", "-o", "copy.node", "--scalar", "r2=x^2+y^2+z^2", "--quiet"});
  const auto info = infoOf("copy.node");
  EXPECT_EQ(info["points"], 8);
  EXPECT_EQ(info["tetrahedra"], 6);
  EXPECT_EQ(info["fields"].size(), 3u);  // the attribute, the expression, the region
  EXPECT_EQ(info["fields"][1]["range"], (nlohmann::json{0.0, 3.0}));
}

TEST_F(Mesh, VtuKeepsNamesAndValues) {
  if (!HAVS_WITH_VTK) GTEST_SKIP() << "this build has no VTK";
  writeTetgenMesh(folder, "cube", kCubeNode, kCubeEle);
  mesh({"cube.node", "-o", "copy.vtu", "--scalar", "height=z", "--scalar", "twice=2*z+1"});
  const auto info = infoOf("copy.vtu");
  EXPECT_EQ(info["tetrahedra"], 6);
  EXPECT_EQ(rangeOf(info, "height"), (nlohmann::json{0.0, 1.0}));
  EXPECT_EQ(rangeOf(info, "twice"), (nlohmann::json{1.0, 3.0}));
}

TEST_F(Mesh, FillsASurface) {
  if (!HAVS_WITH_TETGEN) GTEST_SKIP() << "this build has no TetGen";
  folder.write("cube.poly", kCubePoly);
  mesh({"cube.poly", "-o", "coarse.node", "--tetgen", "p", "--quiet"});
  mesh({"cube.poly", "-o", "fine.node", "--tetgen", "pqa0.01", "--scalar", "s=x", "--quiet"});
  const auto coarse = infoOf("coarse.node");
  const auto fine = infoOf("fine.node");
  EXPECT_EQ(coarse["points"], 8);
  EXPECT_GE(fine["tetrahedra"], 100);  // volume 1 in cells of at most 0.01
  EXPECT_LE(fine["quality"]["volume"][1], 0.01 * (1 + 1e-9));
  EXPECT_EQ(fine["fields"][0]["range"], (nlohmann::json{0.0, 1.0}));
}

TEST_F(Mesh, ANewFieldReplacesOneOfItsName) {
  if (!HAVS_WITH_VTK) GTEST_SKIP() << "this build has no VTK";
  writeTetgenMesh(folder, "cube", kCubeNode, kCubeEle);
  mesh({"cube.node", "-o", "a.vtu", "--scalar", "s=x", "--scalar", "s=5+y", "--quiet"});
  EXPECT_EQ(rangeOf(infoOf("a.vtu"), "s"), (nlohmann::json{5.0, 6.0}));
}

}  // namespace
}  // namespace havs::test
