// havs render scene.json: scene files say what the command line can say, and are written from it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "cli/run_havs.h"
#include "cli/sample_files.h"

namespace havs::test {
namespace {

using Json = nlohmann::json;
using testing::HasSubstr;

class SceneFile : public testing::Test {
 protected:
  void SetUp() override { writeTetgenMesh(folder, "cube", kCubeNode, kCubeEle); }

  std::string havs(const std::vector<std::string>& arguments) {
    const Outcome run = runHavs(arguments, folder.path());
    EXPECT_EQ(run.status, 0) << run.error;
    return run.output;
  }
  Json settings(const std::vector<std::string>& arguments) {
    std::vector<std::string> all{"render"};
    all.insert(all.end(), arguments.begin(), arguments.end());
    all.emplace_back("--json");
    return Json::parse(havs(all));
  }
  void expectRefused(const std::vector<std::string>& arguments, const std::string& why) {
    const Outcome run = runHavs(arguments, folder.path());
    EXPECT_EQ(run.status, 2) << run.error;
    EXPECT_THAT(run.error, HasSubstr(why));
    EXPECT_EQ(std::count(run.error.begin(), run.error.end(), '\n'), 1) << run.error;
  }

  TemporaryFolder folder;
};

TEST_F(SceneFile, SavedFromACommandLineDrawsTheSame) {
  std::filesystem::create_directory(folder / "elsewhere");
  folder.write("ramp.json", R"({"version": 1, "opacity": "extinction", "points": [
    {"scalar": 0, "color": [0, 0, 1], "opacity": 0}, {"scalar": 1, "color": [1, 0, 0], "opacity": 0.5}]})");
  folder.write("camera.json", R"({"azimuth": 70, "elevation": -10, "zoom": 1.5})");
  const std::vector<std::vector<std::string>> lines{
      {},
      {"--tf", "ramp.json", "--domain", "0.5,2.5", "--background", "0,0.5,1", "--k", "3", "--sort", "centroid"},
      {"--tf", "shells", "--camera", R"({"eye": [3, 2, 1], "target": [0.5, 0.5, 0.5]})", "--unit-length", "0.125"},
      {"--camera", "camera.json", "--projection", "orthographic", "--background", "none", "--lookup", "3d", "--table",
       "16", "--table-format", "rgba8", "--early-termination", "0.75", "--threads", "1"},
      {"--clip-plane", "0.5,0.5,0.5,1,-0.5,0.25", "--clip-plane", "0,0,1,0,0,-1", "--threshold", "-1,3.5"},
      {"--clip-box", "0.1,0.9,0.2,2,-1,0.8", "--cut-box", "0,0.5,0,0.5,0,0.5", "--cut-box", "0.7,1,0.7,1,0.7,1"},
      {"--isosurface", "0.75,red,0.5", "--isosurface", "1.5,0.25,0.5,0.75", "--isosurface", "2,,0.125", "--isosurface",
       "2.5,#102030", "--isosurface", "1", "--device", "native"},
      {"--mode", "isosurfaces", "--isosurface", "1.25"},
      {"--background", "#102030..1,0.5,0", "--outline", "default", "--wireframe", "color=0.5,0.25,1,feature_angle=10"},
      {"--outline", "color=red,width=3", "--surface", "color=#102030,opacity=0.5,shading=none", "--wireframe",
       "width=2.5,opacity=0.75"},
      {"--paper", "--device", "native", "--k", "auto", "--tetgen", "pq", "--field", "attribute0"}};
  for (const auto& line : lines) {
    std::vector<std::string> all{"render", "cube.node", "--size",       "40x30",
                                 "-o",     "a.pfm",     "--save-scene", "elsewhere/scene.json"};
    all.insert(all.end(), line.begin(), line.end());
    havs(all);
    const std::string expected = contentOf(folder / "a.pfm");
    std::filesystem::remove(folder / "a.pfm");
    havs({"render", "elsewhere/scene.json"});
    EXPECT_EQ(contentOf(folder / "a.pfm"), expected) << contentOf(folder / "elsewhere/scene.json");
  }
}

TEST_F(SceneFile, IsReadByTheReferenceToo) {
  folder.write("scene.json", R"({"version": 1, "mesh": "cube.node", "size": [24, 16], "outputs": ["b.pfm"]})");
  havs({"reference", "scene.json"});
  havs({"reference", "cube.node", "--size", "24x16", "-o", "a.pfm"});
  EXPECT_EQ(contentOf(folder / "a.pfm"), contentOf(folder / "b.pfm"));
}

TEST_F(SceneFile, TheCommandLineWinsAndSetComesBeforeIt) {
  folder.write("scene.json",
               R"({"version": 1, "mesh": "cube.node", "size": [24, 16], "k": 4, "camera": {"azimuth": 10}})");
  EXPECT_EQ(settings({"scene.json"})["settings"]["k"], 4);
  EXPECT_EQ(settings({"scene.json", "--set", "k=5"})["settings"]["k"], 5);
  EXPECT_EQ(settings({"scene.json", "--set", "k=5", "--k", "2"})["settings"]["k"], 2);
  EXPECT_EQ(settings({"scene.json", "--set", "background=black"})["settings"]["background"], (Json{0.0, 0.0, 0.0}));
  const Json gradient{{"bottom", {0.0, 0.5, 1.0}}, {"top", {1.0, 1.0, 1.0}}};
  for (const std::string& background : std::vector<std::string>{"0,0.5,1..white", gradient.dump()})
    EXPECT_EQ(settings({"scene.json", "--set", "background=" + background})["settings"]["background"], gradient);
  const Json line{{"color", {0.25, 0.5, 1.0}}, {"width", 2.0}};
  EXPECT_EQ(settings({"scene.json", "--set", "outline=" + line.dump()})["settings"]["outline"], line);
  EXPECT_EQ(settings({"scene.json", "--set", "outline=default"})["settings"]["outline"]["width"], 1.5);
  EXPECT_EQ(settings({"scene.json"})["settings"]["outline"], Json());
  EXPECT_EQ(settings({"scene.json", "--set", "size=[8, 9]"})["settings"]["size"], (Json{8, 9}));
  const Json box{0.0, 1.0, 0.0, 1.0, 0.0, 0.5}, other{0.0, 1.0, 0.0, 0.5, 0.0, 1.0};
  const std::string oneBox = "clip_box=" + box.dump(), twoBoxes = "clip_box=" + Json{box, other}.dump();
  EXPECT_EQ(settings({"scene.json", "--set", oneBox})["settings"]["clip_box"], Json::array({box}));
  EXPECT_EQ(settings({"scene.json", "--set", twoBoxes})["settings"]["clip_box"], (Json{box, other}));
  EXPECT_EQ(settings({"scene.json", "--set", twoBoxes, "--clip-box", "0,1,0,1,0,0.5"})["settings"]["clip_box"],
            Json::array({box}));
  const Json turned = settings({"scene.json", "--set", "camera.azimuth=90", "--set", "camera.zoom=2"})["settings"];
  EXPECT_EQ(turned["camera"],
            settings({"scene.json", "--camera", R"({"azimuth": 90, "zoom": 2})"})["settings"]["camera"]);
}

TEST_F(SceneFile, WrongOnesAreRefused) {
  const auto refused = [&](const std::string& content, const std::string& why) {
    folder.write("scene.json", content);
    expectRefused({"render", "scene.json"}, why);
  };
  refused("{", "no valid JSON");
  refused("[1]", "object");
  refused("{}", "'version' must be 1");
  refused(R"({"version": 2, "mesh": "cube.node"})", "'version' must be 1");
  refused(R"({"version": 1})", "'mesh' is missing");
  refused(R"({"version": 1, "mesh": "cube.node", "lokup": "3d"})", "'lookup'");
  refused(R"({"version": 1, "mesh": "cube.node", "k": "many"})", "'k' must be");
  refused(R"({"version": 1, "mesh": "cube.node", "k": 2.5})", "'k' must be");
  refused(R"({"version": 1, "mesh": "cube.node", "table": "64"})", "'table' must be a whole number");
  refused(R"({"version": 1, "mesh": "cube.node", "table": 99999999999})", "'table' must be");
  refused(R"({"version": 1, "mesh": "cube.node", "size": [1]})", "'size' must be two");
  refused(R"({"version": 1, "mesh": "cube.node", "clip_plane": [[0, 0, 0, 1, 0]]})",
          "'clip_plane' must be a list of six");
  refused(R"({"version": 1, "mesh": "cube.node", "cut_box": "0,1,0,1,0,1"})", "'cut_box' must be a list of six");
  refused(R"({"version": 1, "mesh": "cube.node", "clip_box": [0, 1, 1, 0, 0, 1]})", "--clip-box");
  refused(R"({"version": 1, "mesh": "cube.node", "threshold": 3})", "'threshold' must be two numbers");
  refused(R"({"version": 1, "mesh": "cube.node", "paper": 1})", "'paper' must be true or false");
  refused(R"({"version": 1, "mesh": "cube.node", "camera": {"azimut": 3}})", "'azimuth'");
  refused(R"({"version": 1, "mesh": "cube.node", "outputs": "a.png"})", "'outputs' must be a list");
  refused(R"({"version": 1, "mesh": "cube.node", "isosurfaces": 1})", "'isosurfaces' must be");
  refused(R"({"version": 1, "mesh": "cube.node", "isosurfaces": [{"color": "red"}]})", "'isosurfaces' must be");
  refused(R"({"version": 1, "mesh": "cube.node", "isosurfaces": [{"value": "1"}]})", "'isosurfaces' must be");
  refused(R"({"version": 1, "mesh": "cube.node", "isosurfaces": [{"value": 1, "colour": "red"}]})", "'color'");
  refused(R"({"version": 1, "mesh": "cube.node", "isosurfaces": {"value": 1, "opacity": 2}})", "opacity");
  refused(R"({"version": 1, "mesh": "cube.node", "background": {"bottom": "red"}})", "'background' must be");
  refused(R"({"version": 1, "mesh": "cube.node", "outline": 2})", "'outline' must be");
  refused(R"({"version": 1, "mesh": "cube.node", "surface": {"opacity": true}})", "'surface' must be");
  refused(R"({"version": 1, "mesh": "cube.node", "surface": {"opcity": 1}})", "'opacity'");
  refused(R"({"version": 1, "mesh": "cube.node", "wireframe": {"color": [1, 2]}})", "'wireframe' must be");
  refused(R"({"version": 1, "mesh": "no.node"})", "no.node");
  refused(R"({"version": 1, "mesh": "cube.node", "sort": "toplogical"})", "topological");
  expectRefused({"render", "nowhere.json"}, "nowhere.json");
  expectRefused({"render", "cube.node", "--set", "k=3"}, "INPUT is none");
  folder.write("scene.json", R"({"version": 1, "mesh": "cube.node"})");
  expectRefused({"render", "scene.json", "--set", "k"}, "--set");
  expectRefused({"render", "scene.json", "--set", "mesh.name=3"}, "--set");
  expectRefused({"render", "scene.json", "--save-scene", "no/where.json"}, "no");
}

/// Every option that describes a scene has its key, and every key its option.
TEST_F(SceneFile, SchemaKnowsEveryOptionOfAScene) {
  const std::string help = havs({"render", "--help"});
  const Json properties = Json::parse(havs({"schema"}))["properties"];
  std::set<std::string> options;
  for (const auto& [name, schema] : properties.items()) {
    if (!schema.contains("description")) continue;
    std::istringstream words(schema["description"].get<std::string>());
    for (std::string word; words >> word;)
      if (word.starts_with("--")) options.insert(word.substr(0, word.find_first_of(";,")));
  }
  for (const std::string& option : options) EXPECT_THAT(help, HasSubstr(option));
  std::istringstream lines(help.substr(help.find("Mesh and field:")));
  for (std::string line; std::getline(lines, line) && !line.starts_with("Output:");) {
    if (!line.starts_with("  --")) continue;
    EXPECT_EQ(options.count(line.substr(2, line.find(' ', 2) - 2)), 1u) << line;
  }
}

TEST_F(SceneFile, SchemaIsTheOneThatIsPublished) {
  EXPECT_EQ(havs({"schema"}), contentOf(std::filesystem::path(HAVS_SOURCE) / "docs" / "scene.schema.json"))
      << "havs schema > docs/scene.schema.json";
}

}  // namespace
}  // namespace havs::test
