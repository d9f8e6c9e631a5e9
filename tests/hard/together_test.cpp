// Several runs at once.
#include <list>

#include "hard/denied_calls.h"
#include "hard/trouble.h"

namespace havs::test {
namespace {

using testing::HasSubstr;

class Together : public TroubleTest {
 protected:
  static std::vector<std::string> render(int azimuth) {
    return {"render", "cube.node", "--size", "64x64", "--table", "16", "--camera", std::to_string(azimuth) + ",10",
            "--quiet"};
  }
  static std::vector<std::string> into(std::vector<std::string> arguments, const std::string& file) {
    arguments.insert(arguments.end(), {"-o", file});
    return arguments;
  }
  static constexpr int kRuns = 4;
};

TEST_F(Together, FourRendersIntoOneFolder) {
  tell({"Trouble while running", "runs that share a folder share the names of what they write aside",
        "such files have no name, or one of the process's own"});
  std::map<std::string, std::string> whole;
  for (int i = 0; i < kRuns; ++i) whole[std::to_string(i) + ".png"] = undisturbed(render(90 * i + 7));
  int failed = 0;
  for (const Preparation& prepare : {Preparation{}, Preparation(denyNamelessFiles)}) {
    std::list<StartedRun> runs;
    for (int i = 0; i < kRuns; ++i)
      runs.emplace_back(into(render(90 * i + 7), std::to_string(i) + ".png"), folder.path(), prepare);
    for (StartedRun& one : runs) failed += one.wait().status != 0;
    failed += files() != whole;
  }
  expectAtMost("wrong runs", failed, 0);
}

TEST_F(Together, FourRendersIntoOneFile) {
  tell({"Trouble while running", "four writers of one file mix their bytes",
        "each writes its own, and takes the place when it is whole: at every moment the file is one of the four"});
  std::set<std::string> whole;
  for (int i = 0; i < kRuns; ++i) whole.insert(undisturbed(render(90 * i + 7)));
  ASSERT_EQ(whole.size(), 4u);
  int mixed = 0, failed = 0, left = 0;
  for (const Preparation& prepare : {Preparation{}, Preparation(denyNamelessFiles), Preparation{}}) {
    std::list<StartedRun> runs;
    for (int i = 0; i < kRuns; ++i) runs.emplace_back(into(render(90 * i + 7), "a.png"), folder.path(), prepare);
    const auto allEnded = [&] {
      bool all = true;
      for (StartedRun& one : runs) all = one.hasEnded() && all;
      mixed += std::filesystem::exists(folder / "a.png") && !whole.contains(contentOf(folder / "a.png"));
      return all;
    };
    ASSERT_TRUE(waitUntil(allEnded));
    for (StartedRun& one : runs) failed += one.wait().status != 0;
    left += static_cast<int>(files().size()) - 1;
    std::filesystem::remove(folder / "a.png");
  }
  expectAtMost("mixed files seen", mixed, 0);
  expectAtMost("runs that failed", failed, 0);
  expectAtMost("files left beside it", left, 0);
}

TEST_F(Together, TwoStudiesInOneFolder) {
  tell({"Trouble while running", "two studies that append to one file measure each other",
        "the file is locked while a study runs; the second is refused and changes nothing"});
  const std::vector<std::string> arguments{"study",          "cube.node", "--out",      "out",      "--size",
                                           "16x16",          "--axis",    "table=8,16", "--repeat", "5000",
                                           "--combinations", "0",         "--quiet"};
  StartedRun first(arguments, folder.path());
  ASSERT_TRUE(waitUntil(
      [&] { return contentOf(folder / "out/runs.jsonl").find("visit") != std::string::npos || first.hasEnded(); }));
  const Outcome second = run(arguments);
  const bool stillRunning = !first.hasEnded();
  first.send(SIGINT);
  const Outcome outcome = first.wait();
  EXPECT_TRUE(stillRunning) << "the first study was too short to be met";
  EXPECT_EQ(outcome.status, 130) << outcome.error;
  EXPECT_THAT(second.error, HasSubstr("another study is running there; wait for it, or choose another folder"));
  expectAtMost("status of the second - 2", std::abs(second.status - 2), 0);
  std::istringstream lines(contentOf(folder / "out/runs.jsonl"));
  int studies = 0;
  for (std::string line; std::getline(lines, line);) studies += line.starts_with("{\"study\"");
  expectAtMost("studies in the file", studies, 1);
}

}  // namespace
}  // namespace havs::test
