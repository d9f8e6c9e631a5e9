#include <gmock/gmock.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "cli/run_havs.h"
#include "cli/sample_files.h"

namespace havs::test {
namespace {

using testing::HasSubstr;

class Info : public testing::Test {
 protected:
  std::string info(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "info");
    const Outcome run = runHavs(arguments, folder.path());
    EXPECT_EQ(run.status, 0) << run.error;
    EXPECT_EQ(run.error, "");
    return run.output;
  }
  TemporaryFolder folder;
};

std::size_t countOf(const nlohmann::json& json, const std::string& defect) {
  for (const auto& row : json["defects"])
    if (row["name"] == defect) return row["count"];
  ADD_FAILURE() << "no row " << defect;
  return 0;
}

TEST_F(Info, CubeInJson) {
  writeTetgenMesh(folder, "cube", kCubeNode, kCubeEle);
  const auto json = nlohmann::json::parse(info({"cube.node", "--json"}));
  EXPECT_EQ(json["points"], 8);
  EXPECT_EQ(json["cells"], 6);
  EXPECT_EQ(json["tetrahedra"], 6);
  EXPECT_EQ(json["bounds"], nlohmann::json::parse("[[0.0, 0.0, 0.0], [1.0, 1.0, 1.0]]"));
  EXPECT_EQ(json["fields"].size(), 2u);
  EXPECT_EQ(json["fields"][0]["centering"], "point");
  EXPECT_EQ(json["fields"][0]["range"], (nlohmann::json{0.0, 3.0}));
  EXPECT_EQ(json["fields"][1]["centering"], "cell");
  EXPECT_EQ(json["fields"][1]["range"], (nlohmann::json{0.0, 5.0}));
  EXPECT_EQ(json["field"]["name"], json["fields"][0]["name"]);
  for (const auto& defect : json["defects"]) EXPECT_EQ(defect["count"], 0) << defect;
}

/// Each of the six cells has edges 1, 1, 1, sqrt 2, sqrt 2, sqrt 3 and volume 1/6; its surface is 1 + sqrt 2.
TEST_F(Info, QualityOfTheCube) {
  writeTetgenMesh(folder, "cube", kCubeNode, kCubeEle);
  const auto quality = nlohmann::json::parse(info({"cube.ele", "--json"}))["quality"];
  constexpr double kRounding = 1e-14;
  EXPECT_NEAR(quality["edge_length"][0], 1, kRounding);
  EXPECT_NEAR(quality["edge_length"][1], std::sqrt(3.0), kRounding);
  EXPECT_NEAR(quality["volume"][0], 1.0 / 6, kRounding);
  EXPECT_NEAR(quality["volume"][1], 1.0 / 6, kRounding);
  const double inscribedRadius = 3 * (1.0 / 6) / (1 + std::sqrt(2.0));
  const double aspect = std::sqrt(3.0) / (2 * std::sqrt(6.0) * inscribedRadius);
  EXPECT_NEAR(quality["median_aspect_ratio"], aspect, kRounding);
}

TEST_F(Info, RegularTetrahedronHasAspectRatioOne) {
  writeTetgenMesh(folder, "one", "4 3 0 0\n0 1 1 1\n1 -1 1 -1\n2 1 -1 -1\n3 -1 -1 1\n", "1 4 0\n0 0 1 2 3\n");
  const auto json = nlohmann::json::parse(info({"one.node", "--json"}));
  EXPECT_NEAR(json["quality"]["aspect_ratio"][1], 1, 1e-14);
  EXPECT_EQ(json["field"], nullptr);
}

/// Neither squares of values nor cubes of lengths may leave the range of a double.
TEST_F(Info, ExtremeUnitsKeepRangesAndShapes) {
  for (const char* unit : {"1e-150", "1e150"}) {
    SCOPED_TRACE(unit);
    const std::string u = unit;
    writeTetgenMesh(folder, "one",
                    "4 3 0 0\n0 " + u + " " + u + " " + u + "\n1 -" + u + " " + u + " -" + u + "\n2 " + u + " -" + u +
                        " -" + u + "\n3 -" + u + " -" + u + " " + u + "\n",
                    "1 4 0\n0 0 1 2 3\n");
    const auto json = nlohmann::json::parse(info({"one.node", "--json"}));
    EXPECT_NEAR(json["quality"]["aspect_ratio"][1], 1, 1e-14);
    const double edge = std::sqrt(8.0) * std::stod(u);
    EXPECT_NEAR(json["quality"]["edge_length"][1], edge, 1e-14 * edge);
  }
}

TEST_F(Info, DefectsAreCountedBeforeRepair) {
  const std::string cells = "4 4 0\n0 0 1 3 7\n1 0 2 3 7\n2 0 1 3 7\n3 0 1 2 3\n";  // sound, inverted, twice, flat
  writeTetgenMesh(folder, "bad", kCubeNode, cells);
  const auto json = nlohmann::json::parse(info({"bad.node", "--json"}));
  EXPECT_EQ(json["tetrahedra"], 4);
  EXPECT_EQ(countOf(json, "flat_cells"), 1u);
  EXPECT_EQ(countOf(json, "duplicate_cells"), 1u);
  EXPECT_EQ(countOf(json, "unreferenced_points"), 3u);
  EXPECT_THAT(info({"bad.node"}), HasSubstr("flat_cells: 1, the first number 3"));
}

TEST_F(Info, TextListsFieldsAndDefects) {
  writeTetgenMesh(folder, "cube", kCubeNode, kCubeEle);
  const std::string text = info({"cube.node"});
  EXPECT_THAT(text, HasSubstr("tetrahedra  6\n"));
  EXPECT_THAT(text, HasSubstr("point data, 1 component, 0 to 3"));
  EXPECT_THAT(text, HasSubstr("defects     none"));
}

TEST_F(Info, QuietPrintsNothing) {
  writeTetgenMesh(folder, "cube", kCubeNode, kCubeEle);
  EXPECT_EQ(info({"cube.node", "--quiet"}), "");
}

}  // namespace
}  // namespace havs::test
