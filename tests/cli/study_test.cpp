// havs study on a mesh of six tetrahedra and pictures of a few pixels.
#include <gmock/gmock.h>

#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "cli/run_havs.h"
#include "cli/sample_files.h"
#include "image/image.h"

namespace havs::test {
namespace {

using nlohmann::json;
using testing::HasSubstr;

class StudyCommand : public testing::Test {
 protected:
  StudyCommand() { writeTetgenMesh(folder, "cube", kCubeNode, kCubeEle); }

  std::vector<std::string> arguments(const std::string& out = "out", const std::vector<std::string>& more = {}) const {
    std::vector<std::string> all{"study",   "cube.node",  "--out",    out,       "--size",         "24x16",
                                 "--table", "16",         "--axis",   "k=1,2,6", "--axis",         "table=4,8,16",
                                 "--axis",  "size=12,24", "--repeat", "3",       "--combinations", "2"};
    all.insert(all.end(), more.begin(), more.end());
    return all;
  }
  Outcome study(const std::string& out = "out", const std::vector<std::string>& more = {},
                const Preparation& prepare = {}) const {
    return runHavs(arguments(out, more), folder.path(), prepare);
  }
  json result(const std::string& out = "out") const { return json::parse(contentOf(folder / out / "study.json")); }

  /// What each line of runs.jsonl says of visits: how often each run was visited in each round.
  std::map<std::string, std::map<int, int>> visits(const std::string& out) const {
    std::map<std::string, std::map<int, int>> counts;
    std::istringstream lines(contentOf(folder / out / "runs.jsonl"));
    for (std::string line; std::getline(lines, line);) {
      const json record = json::parse(line);
      if (record.contains("visit")) ++counts[record["visit"]["run"]][record["visit"]["round"].get<int>()];
    }
    return counts;
  }

  /// Everything was visited once a round, and nothing else.
  void expectWhole(const std::string& out) const {
    const json study = result(out);
    EXPECT_TRUE(study["complete"]);
    const auto counts = visits(out);
    EXPECT_EQ(counts.size(), study["runs"].size());
    for (const auto& [run, rounds] : counts) EXPECT_EQ(rounds, (std::map<int, int>{{0, 1}, {1, 1}, {2, 1}})) << run;
    for (const json& run : study["runs"]) {
      EXPECT_EQ(run["repetitions"], 3);
      EXPECT_TRUE(counts.contains(run["id"])) << run["id"];
      EXPECT_TRUE(std::filesystem::exists(folder / out / run["image"].get<std::string>())) << run["id"];
    }
  }

  TemporaryFolder folder;
};

std::set<std::string> idsOf(const json& study, const std::string& exceptKind = "") {
  std::set<std::string> ids;
  for (const json& run : study["runs"])
    if (run["kind"] != exceptKind) ids.insert(run["id"]);
  return ids;
}

TEST_F(StudyCommand, MeasuresEachAxisAndTheFront) {
  const Outcome run = study();
  ASSERT_EQ(run.status, 0) << run.error;
  EXPECT_THAT(run.output, HasSubstr("* "));
  expectWhole("out");
  const json study = result();
  EXPECT_EQ(idsOf(study, "front"), (std::set<std::string>{"cube-0/baseline", "cube-0/paper", "cube-0/k=1", "cube-0/k=2",
                                                          "cube-0/table=4", "cube-0/table=8", "cube-0/size=12"}));
  int onFront = 0;
  for (const json& one : study["runs"]) {
    EXPECT_TRUE(one["failed"].is_null()) << one["failed"];
    EXPECT_GT(one["frame_wall_ms"]["median"], 0);
    EXPECT_LE(one["error"]["p999"], one["error"]["max"]);
    EXPECT_LE(one["error"]["max"], one["error_with_masked_pixels"]["max"]);
    onFront += one["on_front"] == true;
  }
  EXPECT_GT(onFront, 0);
  EXPECT_EQ(readImage(folder / "out/images/cube-0_size=12.png").width, 12);
  EXPECT_EQ(readImage(folder / "out" / study["subjects"][0]["reference"]["image"].get<std::string>()).height, 16);
}

TEST_F(StudyCommand, PrintsTheJsonThatItWrites) {
  const Outcome run = study("out", {"--json"});
  ASSERT_EQ(run.status, 0) << run.error;
  EXPECT_EQ(json::parse(run.output), result());
}

TEST_F(StudyCommand, TakesMeshesAndCameras) {
  writeTetgenMesh(folder, "other", kCubeNode, kCubeEle);
  const Outcome run = runHavs({"study",
                               "cube.node",
                               "other.ele",
                               "--camera",
                               "0,10",
                               "--camera",
                               R"({"azimuth": 90})",
                               "--out",
                               "out",
                               "--size",
                               "8x8",
                               "--axis",
                               "k=1,2",
                               "--table",
                               "4",
                               "--repeat",
                               "1",
                               "--combinations",
                               "0",
                               "--quiet"},
                              folder.path());
  ASSERT_EQ(run.status, 0) << run.error;
  EXPECT_EQ(run.output, "");
  std::set<std::string> subjects;
  const json study = result();
  for (const json& subject : study["subjects"]) subjects.insert(subject["id"]);
  EXPECT_EQ(subjects, (std::set<std::string>{"cube-0", "cube-1", "other-0", "other-1"}));
  EXPECT_NE(study["subjects"][0]["camera"]["eye"], study["subjects"][1]["camera"]["eye"]);
}

TEST_F(StudyCommand, MeasuresNothingAgainWhenAllIsThere) {
  ASSERT_EQ(study().status, 0);
  const std::string before = contentOf(folder / "out/runs.jsonl");
  std::filesystem::remove(folder / "out/study.json");
  ASSERT_EQ(study().status, 0);
  EXPECT_EQ(contentOf(folder / "out/runs.jsonl"), before);
  EXPECT_EQ(result()["runs"].size(), visits("out").size());
}

TEST_F(StudyCommand, GoesOnAfterALineThatIsNotWhole) {
  ASSERT_EQ(study().status, 0);
  const json before = result();
  const std::string text = contentOf(folder / "out/runs.jsonl");
  folder.write("out/runs.jsonl", text.substr(0, text.size() * 2 / 3));
  const Outcome again = study();
  ASSERT_EQ(again.status, 0) << again.error;
  expectWhole("out");
  // The times that the combinations are chosen by were measured again; everything else is the same.
  EXPECT_EQ(idsOf(result(), "front"), idsOf(before, "front"));
}

/// Ends this process, soon to be havs, once the file has so many lines.
void killAtLine(const std::string& file, std::ptrdiff_t lines) {
  const pid_t target = getpid();
  if (fork() != 0) return;
  while (getppid() == target) {
    const std::string text = contentOf(file);
    if (std::count(text.begin(), text.end(), '\n') >= lines) kill(target, SIGKILL);
    usleep(500);
  }
  _exit(0);
}

TEST_F(StudyCommand, GoesOnAfterBeingKilled) {
  const std::string file = folder / "out/runs.jsonl";
  for (const std::ptrdiff_t lines : {3, 7, 15, 21}) {
    const Outcome killed = study("out", {}, [&] { killAtLine(file, lines); });
    EXPECT_EQ(killed.status, -SIGKILL) << lines;
    EXPECT_FALSE(std::filesystem::exists(folder / "out/study.json"));
  }
  const Outcome run = study();
  ASSERT_EQ(run.status, 0) << run.error;
  expectWhole("out");
  ASSERT_EQ(study("whole").status, 0);
  // Which combinations are tried depends on times; the rest does not.
  EXPECT_EQ(idsOf(result("out"), "front"), idsOf(result("whole"), "front"));
}

TEST_F(StudyCommand, BeginsAnewWhenAsked) {
  ASSERT_EQ(study("out", {"--seed", "5"}).status, 0);
  EXPECT_EQ(study().status, 2);
  ASSERT_EQ(study("out", {"--restart"}).status, 0);
  expectWhole("out");
}

TEST_F(StudyCommand, RecordsWhatCannotBeDrawnAndGoesOn) {
  const Outcome run = runHavs({"study", "cube.node", "--out", "out", "--size", "8x8", "--table", "4", "--axis",
                               "k=1,99", "--repeat", "1", "--combinations", "1"},
                              folder.path());
  ASSERT_EQ(run.status, 0) << run.error;
  EXPECT_THAT(run.output, HasSubstr("k=99: k is 99"));
  EXPECT_THAT(result()["skipped"].dump(), HasSubstr("k is 99"));
}

}  // namespace
}  // namespace havs::test
