// havs reference, as a user runs it.
#include <gmock/gmock.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "cli/json_keys.h"
#include "cli/run_havs.h"
#include "cli/sample_files.h"
#include "image/image.h"
#include "image/mask.h"

namespace havs::test {
namespace {

using testing::HasSubstr;

class Reference : public testing::Test {
 protected:
  Reference() { writeTetgenMesh(folder, "cube", kCubeNode, kCubeEle); }

  /// Must succeed without a word on standard error.
  std::string run(const std::string& command, std::vector<std::string> options) {
    options.insert(options.begin(), {command, "cube.node", "--size", "48x32"});
    const Outcome outcome = runHavs(options, folder.path());
    EXPECT_EQ(outcome.status, 0) << outcome.error;
    EXPECT_EQ(outcome.error, "");
    return outcome.output;
  }
  std::string reference(const std::vector<std::string>& options) { return run("reference", options); }

  TemporaryFolder folder;
};

TEST_F(Reference, JsonHoldsWhatHasAMeaning) {
  const auto json = nlohmann::json::parse(reference({"-o", "a.png", "--json"}));
  EXPECT_THAT(keysOf(json),
              testing::UnorderedElementsAre("mesh", "field", "settings", "device", "stages_ms", "frame_ms", "cpu_ms",
                                            "peak_memory_bytes", "defects", "notes", "outputs"));
  EXPECT_THAT(keysOf(json["settings"]),
              testing::UnorderedElementsAre("transfer_function", "mode", "isosurfaces", "outline", "surface",
                                            "wireframe", "clip_plane", "clip_box", "cut_box", "threshold", "lighting",
                                            "lights", "shadows", "occlusion", "scattering", "modulation", "camera",
                                            "size", "background", "threads", "repeat"));
  EXPECT_THAT(keysOf(json["stages_ms"]), testing::UnorderedElementsAre("read", "prepare", "faces", "draw", "total"));
  EXPECT_EQ(json["device"], (nlohmann::json{{"name", "reference"}, {"tiles", 2}}));
  EXPECT_EQ(json["mesh"]["cells"], 6);
  EXPECT_EQ(json["frame_ms"], json["stages_ms"]["draw"]);
}

TEST_F(Reference, AgreesWithTheKBufferOutsideTheMask) {
  for (const char* projection : {"perspective", "orthographic"})
    for (const char* field : {"attribute0", "region"}) {  // at the points, in the cells
      const std::vector<std::string> same{"--projection", projection, "--field", field, "--camera", "35,25"};
      auto with = [&](std::vector<std::string> options) {
        options.insert(options.end(), same.begin(), same.end());
        return options;
      };
      reference(with({"-o", "r.exr", "--edge-mask", "m.png"}));
      run("render", with({"-o", "k.exr"}));
      const Image r = readImage(folder / "r.exr"), k = readImage(folder / "k.exr");
      int width = 0, height = 0;
      const auto mask = readMask(folder / "m.png", width, height);
      ASSERT_EQ(width, 48);
      ASSERT_EQ(height, 32);
      float most = 0, seen = 0;
      for (std::size_t i = 0; i < r.rgba.size(); ++i) {
        if (mask[i / 4]) continue;
        most = std::max(most, std::abs(r.rgba[i] - k.rgba[i]));
        seen = std::max(seen, r.rgba[i]);
      }
      EXPECT_LE(most, 1e-3f) << projection << ' ' << field;  // the table is interpolated
      EXPECT_GT(seen, 0.1f);
    }
}

TEST_F(Reference, MethodAndThreadsDoNotChangeThePicture) {
  reference({"-o", "a.pfm", "--threads", "1"});
  reference(
      {"-o", "b.pfm", "--threads", "3", "--repeat", "2", "--paper", "--k", "2", "--lookup", "post", "--device", "egl"});
  EXPECT_EQ(contentOf(folder / "a.pfm"), contentOf(folder / "b.pfm"));
}

TEST_F(Reference, MasksAreWrittenOnlyWhereAskedFor) {
  const std::size_t before = folder.entries();
  EXPECT_EQ(reference({"-o", "a.png", "--quiet"}), "");
  EXPECT_EQ(folder.entries(), before + 1);
  const std::string text = reference({"--edge-mask", "m.png"});
  EXPECT_EQ(folder.entries(), before + 2);
  EXPECT_THAT(text, HasSubstr("the reference"));
  EXPECT_THAT(text, HasSubstr("8 points, 6 tetrahedra"));
}

TEST_F(Reference, HelpSaysWhatHasNoEffect) {
  const Outcome outcome = runHavs({"reference", "--help"}, folder.path());
  EXPECT_EQ(outcome.status, 0);
  for (const char* part : {"--edge-mask", "--camera", "--tf", "no effect", "--threads"})
    EXPECT_THAT(outcome.output, HasSubstr(part));
}

}  // namespace
}  // namespace havs::test
