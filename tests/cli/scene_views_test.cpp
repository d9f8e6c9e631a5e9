// Scene files with several views: pictures of one scene by several cameras.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "cli/run_havs.h"
#include "cli/sample_files.h"

namespace havs::test {
namespace {

using Json = nlohmann::json;
using testing::HasSubstr;

class SceneViews : public testing::TestWithParam<std::string> {
 protected:
  void SetUp() override {
    writeTetgenMesh(folder, "cube", kCubeNode, kCubeEle);
    folder.write("two.json", R"({"version": 1, "mesh": "cube.node", "size": [40, 30], "camera": "20,10",
      "views": [{"outputs": ["a.exr", "a.png"]},
                {"camera": {"azimuth": 70, "zoom": 2}, "projection": "orthographic", "outputs": ["b.exr"]}]})");
  }
  std::string havs(const std::vector<std::string>& arguments) {
    const Outcome run = runHavs(arguments, folder.path());
    EXPECT_EQ(run.status, 0) << run.error;
    return run.output;
  }
  void expectRefused(const std::vector<std::string>& arguments, const std::string& why) {
    const Outcome run = runHavs(arguments, folder.path());
    EXPECT_EQ(run.status, 2) << run.error;
    EXPECT_THAT(run.error, HasSubstr(why));
    EXPECT_EQ(std::count(run.error.begin(), run.error.end(), '\n'), 1) << run.error;
  }
  void expectSame(const char* one, const char* other) {
    EXPECT_FALSE(contentOf(folder / one).empty());
    EXPECT_TRUE(contentOf(folder / one) == contentOf(folder / other)) << one << ' ' << other;
  }

  TemporaryFolder folder;
};

TEST_P(SceneViews, EachIsThePictureOfItsCameraAlone) {
  const std::string command = GetParam().substr(0, GetParam().find(' '));
  std::vector<std::string> device;
  if (const auto blank = GetParam().find(' '); blank != std::string::npos)
    device = {"--device", GetParam().substr(blank + 1)};
  const auto draw = [&](std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), command);
    arguments.insert(arguments.end(), device.begin(), device.end());
    return havs(arguments);
  };
  const Json report = Json::parse(draw({"two.json", "--json"}));
  ASSERT_EQ(report["views"].size(), 2);
  EXPECT_EQ(report["views"][0]["outputs"], (Json{"a.exr", "a.png"}));
  EXPECT_GT(report["views"][0]["stages_ms"]["read"], 0);
  EXPECT_EQ(report["views"][1]["stages_ms"].value("read", 0.0), 0) << "the mesh is read once";
  draw({"cube.node", "--size", "40x30", "--camera", "20,10", "-o", "a1.exr", "-o", "a1.png"});
  draw({"cube.node", "--size", "40x30", "--camera", R"({"azimuth": 70, "zoom": 2})", "--projection", "orthographic",
        "-o", "b1.exr"});
  expectSame("a.exr", "a1.exr");
  expectSame("a.png", "a1.png");
  expectSame("b.exr", "b1.exr");
}
INSTANTIATE_TEST_SUITE_P(Commands, SceneViews, testing::Values("render native", "render osmesa", "reference"),
                         [](const auto& test) {
                           std::string name = test.param;
                           std::replace(name.begin(), name.end(), ' ', '_');
                           return name;
                         });

using OneSceneOfViews = SceneViews;
INSTANTIATE_TEST_SUITE_P(Once, OneSceneOfViews, testing::Values("render"));

TEST_P(OneSceneOfViews, EachHasItsOwnKWhereItIsSearched) {
  const Json report = Json::parse(havs({"render", "two.json", "--k", "auto", "--device", "native", "--json"}));
  for (const Json& view : report["views"]) EXPECT_EQ(view["certificate"]["misordered"], 0);
}

TEST_P(OneSceneOfViews, AreSavedAndReadAgain) {
  havs({"render", "two.json", "--save-scene", "again.json", "--quiet"});
  const Json again = Json::parse(contentOf(folder / "again.json"));
  EXPECT_EQ(again["views"], Json::parse(contentOf(folder / "two.json"))["views"]);
  havs({"render", "again.json", "--quiet"});
}

TEST_P(OneSceneOfViews, CanBeLeftOut) {
  havs({"render", "two.json", "--set", "views=null", "-o", "one.exr", "--quiet"});
  havs({"render", "two.json", "--quiet"});
  expectSame("one.exr", "a.exr");
  havs({"render", "two.json", "--set", "views=[]", "-o", "none.exr", "--quiet"});
  expectSame("none.exr", "a.exr");
}

TEST_P(OneSceneOfViews, WhatIsForOnePictureIsRefused) {
  for (const std::vector<std::string>& more : std::vector<std::vector<std::string>>{
           {"-o", "x.png"}, {"--certificate-mask", "x.png"}, {"--max-error", "0.01"}}) {
    std::vector<std::string> line{"render", "two.json"};
    line.insert(line.end(), more.begin(), more.end());
    expectRefused(line, "the scene has 2 views");
  }
  expectRefused({"reference", "two.json", "--edge-mask", "x.png"}, "the scene has 2 views");
  for (const char* file : {"a.png", "a.exr", "b.exr", "x.png"}) EXPECT_FALSE(std::filesystem::exists(folder / file));
}

TEST_P(OneSceneOfViews, WrongOnesAreRefused) {
  const auto views = [&](const std::string& value) {
    return std::vector<std::string>{"render", "two.json", "--set", "views=" + value};
  };
  expectRefused(views("3"), "must be a list of objects, or null");
  expectRefused(views("[3]"), "view 1: must be an object");
  expectRefused(views(R"([{"outputs": ["a.png"], "kamera": "1,2"}])"), "camera");
  expectRefused(views(R"([{"outputs": "a.png"}])"), "'outputs' must be a list of paths");
  expectRefused(views(R"([{"outputs": ["a.png"]}, {"camera": "1,2"}])"), "view 2: 'outputs' is missing");
  expectRefused(views(R"([{"outputs": ["a.png"], "camera": 3}])"), "'camera' must be an object");
  expectRefused(views(R"([{"outputs": ["a.png"], "camera": "x"}])"), "camera");
  expectRefused(views(R"([{"outputs": ["a.gif"]}])"), "a.gif");
  expectRefused(views(R"([{"outputs": ["a.png"]}, {"outputs": ["./a.png"]}])"), "is named twice");
  expectRefused({"render", "two.json", "--set", "outputs=[\"x.png\"]"}, "'outputs' belong to each of the 'views'");
}

}  // namespace
}  // namespace havs::test
