#include <gmock/gmock.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "cli/json_keys.h"
#include "cli/run_havs.h"
#include "cli/sample_files.h"
#include "image/image.h"

namespace havs::test {
namespace {

using testing::HasSubstr;

class Render : public testing::Test {
 protected:
  Render() { writeTetgenMesh(folder, "cube", kCubeNode, kCubeEle); }

  /// havs render cube.node, small and quick, and these; must succeed without a word on standard error.
  std::string render(std::vector<std::string> options) {
    options.insert(options.begin(), {"render", "cube.node", "--size", "48x32", "--table", "16"});
    const Outcome run = runHavs(options, folder.path());
    EXPECT_EQ(run.status, 0) << run.error;
    EXPECT_EQ(run.error, "");
    return run.output;
  }

  TemporaryFolder folder;
};

TEST_F(Render, JsonHoldsEveryKey) {
  const auto json = nlohmann::json::parse(render({"-o", "a.png", "--json"}));
  EXPECT_THAT(keysOf(json),
              testing::UnorderedElementsAre("mesh", "field", "settings", "device", "cycles", "stages_ms", "frame_ms",
                                            "ledger", "cpu_ms", "peak_memory_bytes", "defects", "notes", "outputs"));
  EXPECT_THAT(keysOf(json["stages_ms"]), testing::IsSupersetOf({"read", "faces", "order", "upload", "table", "draw",
                                                                "flush", "readback", "total"}));
  EXPECT_THAT(keysOf(json["settings"]),
              testing::UnorderedElementsAre(
                  "transfer_function", "mode", "isosurfaces", "outline", "surface", "wireframe", "clip_plane",
                  "clip_box", "cut_box", "threshold", "lighting", "lights", "shadows", "occlusion", "scattering",
                  "modulation", "camera", "size", "background", "visibility", "k", "k_auto", "sort", "lookup", "table",
                  "table_format", "target_format", "early_termination", "composite_late", "threads", "repeat"));
}

// The unit cube as it is wanted: half of it, nothing of it, from the middle of it.
TEST_F(Render, OfPartsOfTheMesh) {
  const auto cellsDrawn = [&](std::vector<std::string> options) {
    options.insert(options.end(), {"-o", "a.pfm", "--json"});
    return nlohmann::json::parse(render(options))["mesh"]["drawn_cells"].get<int>();
  };
  const int all = cellsDrawn({});
  EXPECT_GT(cellsDrawn({"--clip-plane", "0.5,0,0,1,0.1,0"}), all);
  EXPECT_EQ(cellsDrawn({"--clip-plane", "-0.5,0,0,1,0,0"}), all);
  EXPECT_EQ(cellsDrawn({"--clip-box", "-.5,-.25,0,1,0,1"}), 0);
  EXPECT_EQ(cellsDrawn({"--cut-box", "-1,2,-1,2,-1,2"}), 0);
  EXPECT_EQ(cellsDrawn({"--threshold", "-10,-9"}), 0);
  const Image nothing = readImage(folder / "a.pfm");
  EXPECT_EQ(nothing.rgba, std::vector<float>(nothing.rgba.size(), 1.0f)) << "the background";
}

TEST_F(Render, FromWithinTheMesh) {
  for (const char* device : {"native", "osmesa"}) {
    render({"--camera", R"({"eye": [0.5, 0.5, 0.5], "target": [0.9, 0.6, 0.7]})", "--device", device, "-o", "a.pfm"});
    const Image inside = readImage(folder / "a.pfm");
    for (std::size_t i = 0; i < inside.rgba.size(); i += 4)
      ASSERT_LT(inside.rgba[i], 0.99f) << device << ": every ray goes through the mesh, before white";
  }
}

TEST_F(Render, LookupsTakeTheirNumberAndKeepTheirName) {
  for (const char* name :
       {"riemann:1", "riemann:256", "riemann-linear:7", "exact", "2d", "3d-normalised", "integral"}) {
    const auto json = nlohmann::json::parse(render({"-o", "a.png", "--json", "--lookup", name}));
    EXPECT_EQ(json["settings"]["lookup"], name);
  }
}

/// With nothing but these options.
nlohmann::json settingsWith(const TemporaryFolder& folder, std::vector<std::string> options) {
  options.insert(options.begin(), {"render", "cube.node", "--size", "8x8", "--json"});
  const Outcome run = runHavs(options, folder.path());
  EXPECT_EQ(run.status, 0) << run.output;
  return nlohmann::json::parse(run.output)["settings"];
}

/// The size that was used, asked for or not; none where there is no table.
TEST_F(Render, JsonTellsTheTableOfEachLookup) {
  const auto tableWith = [&](const std::vector<std::string>& options) {
    return settingsWith(folder, options)["table"];
  };
  EXPECT_EQ(tableWith({"--lookup", "3d-normalised"}), 64);
  EXPECT_EQ(tableWith({"--lookup", "3d"}), 128);
  EXPECT_EQ(tableWith({"--lookup", "2d"}), 512);
  EXPECT_EQ(tableWith({"--lookup", "2d", "--table", "9"}), 9);
  EXPECT_EQ(tableWith({"--lookup", "exact"}), nullptr);
  EXPECT_EQ(settingsWith(folder, {"--paper"})["lookup"], "3d");
  EXPECT_EQ(tableWith({"--paper"}), 128);
  EXPECT_EQ(tableWith({"--paper", "--table", "16"}), 16);
}

TEST_F(Render, LookupByDefaultSuitsTheTransferFunction) {
  const auto lookupWith = [&](const std::vector<std::string>& options) {
    return settingsWith(folder, options)["lookup"];
  };
  EXPECT_EQ(lookupWith({}), "3d-normalised");  // six cells that span the whole of viridis: dozens of knots each
  folder.write("ramp.json", R"({"version": 1, "opacity": "extinction", "points": [
    {"scalar": 0, "color": [0, 0, 1], "opacity": 0}, {"scalar": 1, "color": [1, 0, 0], "opacity": 0.5}]})");
  EXPECT_EQ(lookupWith({"--tf", "ramp.json"}), "exact");
  EXPECT_EQ(lookupWith({"--tf", "ramp.json", "--k", "auto"}), "exact");
  EXPECT_EQ(lookupWith({"--tf", "ramp.json", "--table", "32"}), "3d-normalised");  // exact has none
  EXPECT_EQ(lookupWith({"--tf", "ramp.json", "--table-format", "rgba8"}), "3d-normalised");
}

TEST_F(Render, DeviceByDefaultIsNativeWhereItDraws) {
  const auto deviceWith = [&](const std::vector<std::string>& options) {
    std::vector<std::string> all{"--json"};
    all.insert(all.end(), options.begin(), options.end());
    return nlohmann::json::parse(render(all))["device"]["name"];
  };
  EXPECT_EQ(deviceWith({}), "native");
  EXPECT_EQ(deviceWith({"--visibility", "abuffer"}), "osmesa");
  EXPECT_EQ(deviceWith({"--target-format", "16f"}), "osmesa");
}

TEST_F(Render, JsonTellsWhatWasDrawn) {
  const auto json = nlohmann::json::parse(
      render({"-o", "a.png", "--json", "--k", "3", "--sort", "centroid", "--unit-length", "0.5"}));
  EXPECT_EQ(json["mesh"]["points"], 8);
  EXPECT_EQ(json["mesh"]["cells"], 6);
  EXPECT_EQ(json["mesh"]["drawn_cells"], 6);
  EXPECT_EQ(json["mesh"]["faces"], 18);           // 6 around the diagonal, 12 on the surface
  EXPECT_EQ(json["mesh"]["boundary_faces"], 12);  // two a side
  EXPECT_EQ(json["field"]["centering"], "point");
  EXPECT_EQ(json["field"]["range"], (nlohmann::json{0.0, 3.0}));
  EXPECT_EQ(json["settings"]["k"], 3);
  EXPECT_EQ(json["settings"]["sort"], "centroid");
  EXPECT_EQ(json["settings"]["size"], (nlohmann::json{48, 32}));
  EXPECT_EQ(json["settings"]["transfer_function"]["unit_length"], 0.5);
  EXPECT_EQ(json["settings"]["transfer_function"]["domain"], (nlohmann::json{0.0, 3.0}));
  EXPECT_EQ(json["device"]["name"], "native");
  EXPECT_EQ(json["outputs"], (nlohmann::json{"a.png"}));
  EXPECT_GT(json["stages_ms"]["total"], 0);
  EXPECT_GE(json["stages_ms"]["total"], json["frame_ms"]);
  EXPECT_GT(json["peak_memory_bytes"], 1 << 20);
}

TEST_F(Render, JsonTellsWhatTheABufferKept) {
  const auto json = nlohmann::json::parse(render({"--visibility", "abuffer", "--json"}));
  EXPECT_TRUE(json["settings"]["k"].is_null());
  EXPECT_TRUE(json["settings"]["sort"].is_null());
  EXPECT_GT(json["device"]["fragments"],
            48 * 32 / 10);  // more than one fragment in ten pixels: the cube is in the picture
  EXPECT_EQ(json["device"]["fragment_bytes"], 8 * json["device"]["fragments"].get<std::size_t>());
  EXPECT_THAT(render({"--visibility", "abuffer"}), HasSubstr("fragments in 1 tiles"));
}

TEST_F(Render, EveryVisibilityMethodDrawsTheSamePicture) {
  render({"-o", "kbuffer.exr"});
  const Image expected = readImage(folder / "kbuffer.exr");
  for (const char* method : {"abuffer", "cells"}) {
    render({"-o", "a.exr", "--visibility", method});
    const Image image = readImage(folder / "a.exr");
    ASSERT_EQ(image.rgba.size(), expected.rgba.size());
    for (std::size_t i = 0; i < image.rgba.size(); ++i) ASSERT_NEAR(image.rgba[i], expected.rgba[i], 1e-5) << method;
  }
}

TEST_F(Render, CameraOfTheReportDrawsTheSamePicture) {
  const auto json = nlohmann::json::parse(render({"-o", "a.pfm", "--camera", "70,-10,1.5", "--json"}));
  render({"-o", "b.pfm", "--camera", json["settings"]["camera"].dump()});
  EXPECT_EQ(contentOf(folder / "a.pfm"), contentOf(folder / "b.pfm"));
}

TEST_F(Render, PaperPresetAndOptionsAboveIt) {
  const auto json = nlohmann::json::parse(render({"--paper", "--k", "8", "--json"}));
  EXPECT_EQ(json["settings"]["sort"], "centroid");
  EXPECT_EQ(json["settings"]["table_format"], "rgba8");
  EXPECT_EQ(json["settings"]["early_termination"], 0.99);
  EXPECT_EQ(json["settings"]["composite_late"], true);
  EXPECT_EQ(json["settings"]["k"], 8);
}

TEST_F(Render, CertificateIsReportedWhereAskedFor) {
  EXPECT_FALSE(nlohmann::json::parse(render({"--json"})).contains("certificate"));
  const auto json = nlohmann::json::parse(render({"--json", "--certificate"}));
  EXPECT_EQ(json["certificate"]["misordered"], 0);
  EXPECT_EQ(json["certificate"]["pixels"], 0);
  EXPECT_GT(json["certificate"]["fragments"], 1000);
  EXPECT_THAT(render({"--certificate"}), HasSubstr("order    exact (0 of "));
}

TEST_F(Render, MisorderedFragmentsAreCountedAndShown) {
  const std::vector<std::string> options{"--sort", "none", "--k", "1", "--certificate-mask", "mask.png"};
  const std::string text = render(options);
  EXPECT_THAT(text, testing::ContainsRegex("order    wrong in [0-9]+ pixels .*try --sort topological or --k auto"));
  auto withJson = options;
  withJson.push_back("--json");
  const auto json = nlohmann::json::parse(render(withJson));
  const Image mask = readImage(folder / "mask.png");
  ASSERT_EQ(mask.width, 48);
  ASSERT_EQ(mask.height, 32);
  std::size_t marked = 0;
  for (std::size_t i = 0; i < mask.rgba.size(); i += 4)
    marked += mask.rgba[i] + mask.rgba[i + 1] + mask.rgba[i + 2] > 0;
  EXPECT_GT(marked, 0u);
  EXPECT_EQ(json["certificate"]["pixels"], marked);
  EXPECT_GE(json["certificate"]["misordered"], marked);
}

TEST_F(Render, CertificateLeavesThePictureAsItIs) {
  render({"-o", "a.pfm", "--sort", "none", "--k", "2"});
  render({"-o", "b.pfm", "--sort", "none", "--k", "2", "--certificate"});
  EXPECT_EQ(contentOf(folder / "a.pfm"), contentOf(folder / "b.pfm"));
}

TEST_F(Render, AutomaticKIsTheSmallestThatIsExact) {
  const auto json = nlohmann::json::parse(render({"--sort", "centroid", "--k", "auto", "--json"}));
  EXPECT_EQ(json["settings"]["k_auto"], true);
  EXPECT_EQ(json["certificate"]["misordered"], 0);
  EXPECT_TRUE(json["stages_ms"].contains("k_search"));
  const int k = json["settings"]["k"];
  ASSERT_GT(k, 1);  // the cube's six cells around a diagonal are not in order by themselves
  const auto smaller =
      nlohmann::json::parse(render({"--sort", "centroid", "--k", std::to_string(k - 1), "--certificate", "--json"}));
  EXPECT_GT(smaller["certificate"]["misordered"], 0);
  EXPECT_EQ(smaller["settings"]["k_auto"], false);
}

TEST_F(Render, EveryFormatHoldsThePicture) {
  render({"-o", "a.exr", "-o", "a.png", "-o", "a.pfm", "--background", "white", "--png-bits", "16"});
  const Image exr = readImage(folder / "a.exr");
  const Image png = readImage(folder / "a.png");
  const Image pfm = readImage(folder / "a.pfm");
  ASSERT_EQ(exr.width, 48);
  ASSERT_EQ(exr.height, 32);
  constexpr float kHalfStep = 0.5f / 65535 + 1e-6f;  // of 16 bits, and float's rounding
  float mostOpaque = 0;
  for (int y = 0; y < 32; ++y)
    for (int x = 0; x < 48; ++x) {
      mostOpaque = std::max(mostOpaque, exr.pixel(x, y)[3]);
      for (int c = 0; c < 3; ++c) {
        const float overWhite = exr.pixel(x, y)[c] + 1 - exr.pixel(x, y)[3];
        EXPECT_NEAR(pfm.pixel(x, y)[c], overWhite, 1e-6f) << x << ' ' << y;
        EXPECT_NEAR(png.pixel(x, y)[c], overWhite, kHalfStep) << x << ' ' << y;
      }
    }
  EXPECT_GT(mostOpaque, 0.01f);         // something is seen
  EXPECT_EQ(exr.pixel(0, 0)[3], 0.0f);  // and the corner is empty
}

TEST_F(Render, WithoutBackgroundPngIsTransparent) {
  render({"-o", "a.png", "--background", "none"});
  EXPECT_EQ(readImage(folder / "a.png").pixel(0, 0)[3], 0.0f);
}

TEST_F(Render, RepeatDrawsTheSamePicture) {
  render({"-o", "a.pfm"});
  const auto json = nlohmann::json::parse(render({"-o", "b.pfm", "--repeat", "3", "--json"}));
  EXPECT_EQ(json["settings"]["repeat"], 3);
  EXPECT_EQ(contentOf(folder / "a.pfm"), contentOf(folder / "b.pfm"));
}

TEST_F(Render, ThreadsDoNotChangeThePicture) {
  render({"-o", "a.pfm", "--threads", "1"});
  render({"-o", "b.pfm", "--threads", "3"});
  EXPECT_EQ(contentOf(folder / "a.pfm"), contentOf(folder / "b.pfm"));
}

TEST_F(Render, SummaryNamesMeshFieldAndPicture) {
  const std::string text = render({"-o", "a.png"});
  EXPECT_THAT(text, HasSubstr("8 points, 6 tetrahedra"));
  EXPECT_THAT(text, HasSubstr("(point data), 0 to 3"));
  EXPECT_THAT(text, HasSubstr("mesh units"));
  EXPECT_THAT(text, HasSubstr("a.png"));
}

TEST_F(Render, QuietPrintsNothing) { EXPECT_EQ(render({"-o", "a.png", "--quiet"}), ""); }

TEST_F(Render, NegativeAnglesAndDomains) { render({"--camera", "-30,-20", "--domain", "-1,4.5"}); }

TEST_F(Render, LeavesOnlyThePicture) {
  const std::size_t before = folder.entries();
  render({"-o", "a.png"});
  EXPECT_EQ(folder.entries(), before + 1);
}

TEST(Help, ListsTheRowsOfEveryTable) {
  const TemporaryFolder folder;
  const Outcome run = runHavs({"render", "--help"}, folder.path());
  EXPECT_EQ(run.status, 0);
  for (const char* name : {"osmesa", "egl", "kbuffer", "abuffer", "cells", "centroid", "topological", "3d", "post",
                           "rainbow", ".node", "--paper"})
    EXPECT_THAT(run.output, HasSubstr(name));
}

TEST(Help, OfTheProgramNamesTheCommands) {
  const TemporaryFolder folder;
  const Outcome run = runHavs({"--help"}, folder.path());
  EXPECT_EQ(run.status, 0);
  for (const char* name : {"render", "reference", "info", "mesh"}) EXPECT_THAT(run.output, HasSubstr(name));
}

TEST(Version, IsPrinted) {
  const TemporaryFolder folder;
  const Outcome run = runHavs({"--version"}, folder.path());
  EXPECT_EQ(run.status, 0);
  EXPECT_THAT(run.output, testing::MatchesRegex("havs [0-9]+\\.[0-9]+\\.[0-9]+\n"));
}

}  // namespace
}  // namespace havs::test
