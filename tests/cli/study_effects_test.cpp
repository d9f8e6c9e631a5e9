// havs study --effects on small meshes and pictures of a few pixels. Where light is beside the point it is kept out, by
// settings that know none: its table of scattered light takes seconds.
#include <gmock/gmock.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "cli/run_havs.h"
#include "cli/sample_files.h"
#include "render/effects.h"

namespace havs::test {
namespace {

using nlohmann::json;
using testing::HasSubstr;

class StudyEffects : public testing::TestWithParam<std::string> {
 protected:
  Outcome study(const std::vector<std::string>& more, const std::string& repeat = "3") const {
    std::vector<std::string> all{"study",     kMesh,      "--out",    "out",      "--size", "16x12",
                                 "--effects", "--device", GetParam(), "--repeat", repeat};
    all.insert(all.end(), more.begin(), more.end());
    return runHavs(all, folder.path());
  }
  json result() const { return json::parse(contentOf(folder / "out/study.json")); }
  static const json& effectOf(const json& study, const std::string& name) {
    return *std::find_if(study["effects"].begin(), study["effects"].end(),
                         [&](const json& one) { return one["effect"] == name; });
  }

  const std::string kMesh = std::string(HAVS_MESHES) + "/ramp.node";
  TemporaryFolder folder;
};

double medianOf(const json& spread) { return spread["median"].get<double>(); }

void expectWhole(const json& effect, const std::filesystem::path& out) {
  EXPECT_TRUE(effect["failed"].is_null()) << effect["failed"];
  EXPECT_EQ(effect["repetitions"], 3);
  EXPECT_GT(medianOf(effect["frame_wall_ms"]), 0);
  EXPECT_GT(medianOf(effect["baseline"]["frame_wall_ms"]), 0);
  for (const char* ratio : {"wall_ratio", "cpu_ratio"}) {
    EXPECT_LE(effect[ratio]["least"], effect[ratio]["median"]);
    EXPECT_LE(effect[ratio]["median"], effect[ratio]["most"]);
  }
  EXPECT_GT(effect["prepare_ms"], 0);
  for (const char* picture : {"image", "difference", "reference"})
    EXPECT_TRUE(std::filesystem::exists(out / effect[picture].get<std::string>())) << picture;
  std::size_t bytes = 0;
  for (const json& stage : effect["ledger"]) {
    EXPECT_GE(stage["ms"], 0);
    EXPECT_FALSE(stage["items"].empty());
    bytes += stage["bytes"].get<std::size_t>();
  }
  EXPECT_LE(bytes, effect["bytes"].get<std::size_t>());
}

bool holds(const json& ledger, const std::string& stage) {
  return std::any_of(ledger.begin(), ledger.end(), [&](const json& one) { return one["stage"] == stage; });
}

// The error is that of the picture with the effect, against the reference of that: its bound is that of lit pictures
// in tests/image/light_test.cpp.
TEST_P(StudyEffects, MeasuresEachBesideThePictureWithoutIt) {
  const Outcome run = study({});
  ASSERT_EQ(run.status, 0) << run.error;
  EXPECT_THAT(run.output, HasSubstr("with shadows and lighting"));
  const json study = result();
  EXPECT_TRUE(study["complete"]);
  EXPECT_EQ(study["runs"].size(), 1U) << "no axis was asked for";
  EXPECT_EQ(study["runs"][0]["settings"]["lookup"], "exact");
  ASSERT_EQ(study["effects"].size(), effects().size());
  for (const json& effect : study["effects"]) {
    SCOPED_TRACE(effect["label"]);
    expectWhole(effect, folder / "out");
    EXPECT_TRUE(effect["adds"]);
    EXPECT_LT(effect["error"]["p999"], 5e-3);
  }
  EXPECT_TRUE(holds(effectOf(study, "lighting")["ledger"], "gradients"));
  EXPECT_FALSE(holds(study["runs"][0]["ledger"], "gradients"));
  EXPECT_FALSE(holds(effectOf(study, "ambient scattering")["ledger"], "gradients"));
  EXPECT_GT(effectOf(study, "lighting")["bytes"], study["runs"][0]["bytes"]);
  const std::string table = contentOf(folder / "out/effects.csv");
  EXPECT_EQ(std::count(table.begin(), table.end(), '\n'), static_cast<long>(1 + effects().size()));
}

INSTANTIATE_TEST_SUITE_P(Devices, StudyEffects, testing::Values("native", "osmesa"),
                         [](const auto& test) { return test.param; });

class StudyOfOtherEffects : public StudyEffects {
 protected:
  static bool isSkipped(const json& study, const std::string& run, const std::string& why) {
    return std::any_of(study["skipped"].begin(), study["skipped"].end(), [&](const json& one) {
      const auto text = one.get<std::string>();
      return text.starts_with("ramp-0/" + run + ": ") && text.find(why) != std::string::npos;
    });
  }
};

TEST_P(StudyOfOtherEffects, LeavesOutWhatTheSceneHasAndSkipsWhatItCannotDraw) {
  const Outcome run = study(
      {"--mode", "isosurfaces", "--visibility", "cells", "--isosurface", "1.5", "--clip-plane", "0.5,0.5,0.5,1,0,0"},
      "1");
  ASSERT_EQ(run.status, 0) << run.error;
  const json study = result();
  EXPECT_FALSE(effectOf(study, "clipping")["adds"]);
  EXPECT_EQ(effectOf(study, "clipping")["label"], "without clipping");
  EXPECT_EQ(study["effects"].size() + study["skipped"].size(), effects().size());
  EXPECT_TRUE(isSkipped(study, "without isosurfaces", "nothing to show"));
  EXPECT_TRUE(isSkipped(study, "with lighting", "does not draw lit scenes"));
  EXPECT_THAT(run.output, HasSubstr("skipped: ramp-0/without isosurfaces: "));
}

// Cell data have no isosurfaces: found out when the scene is made ready.
TEST_P(StudyOfOtherEffects, SkipsWhatTheDataDoNotHave) {
  const Outcome run = study({"--field", "region", "--visibility", "cells"}, "1");
  ASSERT_EQ(run.status, 0) << run.error;
  EXPECT_TRUE(isSkipped(result(), "with isosurfaces", "cell"));
}

TEST_P(StudyOfOtherEffects, MeasuresNothingAgainWhenAllIsThere) {
  ASSERT_EQ(study({"--visibility", "cells"}).status, 0);
  const std::string before = contentOf(folder / "out/runs.jsonl");
  const json first = result();
  ASSERT_EQ(study({"--visibility", "cells"}).status, 0);
  EXPECT_EQ(contentOf(folder / "out/runs.jsonl"), before);
  EXPECT_EQ(result()["effects"], first["effects"]);
}

// Killed after some visits: the others are added, none is measured twice.
TEST_P(StudyOfOtherEffects, GoesOnWhereItWas) {
  ASSERT_EQ(study({"--visibility", "cells"}).status, 0);
  const json first = result();
  const std::string text = contentOf(folder / "out/runs.jsonl");
  folder.write("out/runs.jsonl", text.substr(0, text.rfind("\n{", text.size() - 2) + 1));
  ASSERT_EQ(study({"--visibility", "cells"}).status, 0);
  const json again = result();
  ASSERT_EQ(again["effects"].size(), first["effects"].size());
  for (const json& effect : again["effects"]) expectWhole(effect, folder / "out");
  const std::string after = contentOf(folder / "out/runs.jsonl");
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), std::count(after.begin(), after.end(), '\n'));
}

TEST_P(StudyOfOtherEffects, GoBesideAxes) {
  ASSERT_EQ(study({"--visibility", "cells", "--axis", "sort", "--combinations", "0"}, "1").status, 0);
  const json study = result();
  EXPECT_FALSE(study["effects"].empty());
  EXPECT_GE(study["runs"].size(), 3U);  // the default, the paper's, those of the axis
  for (const json& run : study["runs"]) EXPECT_FALSE(run["ledger"].empty());
}

TEST_P(StudyOfOtherEffects, AreThoseOfASceneFile) {
  const auto write = [&](const json& threshold) {
    const json scene{{"version", 1},     {"mesh", kMesh},          {"visibility", "cells"},
                     {"size", {16, 12}}, {"threshold", threshold}, {"device", GetParam()}};
    folder.write("scene.json", scene.dump());
  };
  const std::vector<std::string> arguments{"study", "scene.json", "--out", "out", "--effects", "--repeat", "1"};
  write({1, 5});
  const Outcome run = runHavs(arguments, folder.path());
  ASSERT_EQ(run.status, 0) << run.error;
  EXPECT_EQ(effectOf(result(), "threshold")["label"], "without threshold");
  EXPECT_EQ(result()["runs"][0]["settings"]["visibility"], "cells");
  write({2, 5});
  const Outcome changed = runHavs(arguments, folder.path());
  EXPECT_EQ(changed.status, 2);
  EXPECT_THAT(changed.error, HasSubstr("another command line"));
  const Outcome two = runHavs({"study", "scene.json", kMesh, "--out", "two", "--effects"}, folder.path());
  EXPECT_EQ(two.status, 2);
  EXPECT_THAT(two.error, HasSubstr("scene file is studied by itself"));
}

INSTANTIATE_TEST_SUITE_P(Devices, StudyOfOtherEffects, testing::Values("osmesa"),
                         [](const auto& test) { return test.param; });

}  // namespace
}  // namespace havs::test
