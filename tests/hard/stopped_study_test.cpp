// Studies that are killed or interrupted, and go on.
#include <nlohmann/json.hpp>

#include "hard/trouble.h"
#include "image/image.h"

namespace havs::test {
namespace {

using nlohmann::json;
using testing::HasSubstr;

class StoppedStudy : public TroubleTest {
 protected:
  static std::vector<std::string> study(const std::string& out, const std::string& repeat = "2") {
    return {"study",   "cube.node", "--out",     out,        "--size", "24x16",          "--table", "8",      "--axis",
            "k=1,2,6", "--axis",    "table=4,8", "--repeat", repeat,   "--combinations", "0",       "--quiet"};
  }
  std::filesystem::path out(const std::string& name) const { return folder / "out" / name; }

  /// Files of `out` that are not whole: JSON, CSV, HTML and pictures by their ends. Without a name for what is hidden.
  int broken() const {
    int count = 0;
    for (const auto& [name, content] : files()) {
      const std::string extension = std::filesystem::path(name).extension();
      if (name.ends_with("runs.jsonl")) continue;  // by lines
      bool whole = false;
      if (extension == ".json") whole = json::accept(content);
      if (extension == ".csv") whole = content.ends_with("\n");
      if (extension == ".html") whole = content.find("</html>") != std::string::npos;
      if (extension == ".svg") whole = content.find("</svg>") != std::string::npos;
      if (extension == ".png") whole = readImage(folder / name).width > 0;
      EXPECT_TRUE(whole) << name;
      count += !whole;
    }
    return count;
  }
  std::ptrdiff_t lines() const {
    const std::string text = contentOf(out("runs.jsonl"));
    return std::count(text.begin(), text.end(), '\n');
  }
  /// study.json without what no two studies have alike: times, and what follows from times.
  static json withoutTimes(json value) {
    if (value.is_object()) {
      for (const char* key : {"created", "command", "machine", "on_front", "fits"}) value.erase(key);
      for (auto entry = value.begin(); entry != value.end();) {
        if (entry.key() == "ms" || entry.key().ends_with("_ms") || entry.key().find("peak_memory") != std::string::npos)
          entry = value.erase(entry);
        else
          ++entry;
      }
    }
    if (value.is_structured())
      for (auto& one : value) one = withoutTimes(one);
    return value;
  }
  /// How many files of the finished study differ from those of one that nothing disturbed.
  int differences() const {
    EXPECT_EQ(run(study("undisturbed")).status, 0);
    const auto all = files();
    int count = 0, compared = 0;
    for (const auto& [name, content] : all) {
      if (!name.starts_with("undisturbed/images/")) continue;
      const auto other = all.find("out/" + name.substr(name.find('/') + 1));
      count += other == all.end() || other->second != content;
      ++compared;
    }
    EXPECT_GT(compared, 8);
    const json expected = withoutTimes(json::parse(all.at("undisturbed/study.json")));
    const json found = withoutTimes(json::parse(all.at("out/study.json")));
    EXPECT_EQ(found, expected) << json::diff(expected, found).dump(1);
    std::set<std::string> names, expectedNames;
    for (const auto& [name, content] : all)
      (name.starts_with("out/") ? names : expectedNames).insert(name.substr(name.find('/') + 1));
    EXPECT_EQ(names, expectedNames);
    return count + (found != expected) + (names != expectedNames);
  }
};

TEST_F(StoppedStudy, KilledAtTenMoments) {
  tell({"Trouble while running",
        "a sweep of hours is lost by one power cut, or goes on from a line that is half written",
        "each drawing is a line, flushed to the disk; one that is not whole is dropped; what stands is not drawn "
        "again"});
  ASSERT_EQ(run(study("undisturbed")).status, 0);
  const std::string text = contentOf(folder / "undisturbed/runs.jsonl");
  const auto whole = std::count(text.begin(), text.end(), '\n');
  std::filesystem::remove_all(folder / "undisturbed");
  int killed = 0, halves = 0;
  constexpr int kMoments = 8;
  for (int i = 0; i < kMoments; ++i) {  // by what the file holds, from its beginning to its last line
    StartedRun run(study("out"), folder.path());
    ASSERT_TRUE(waitUntil([&] { return lines() >= whole * i / (kMoments - 1) || run.hasEnded(); }));
    run.send(SIGKILL);
    killed += run.wait().status == -SIGKILL;
    halves += broken();
  }
  for (const char* file : {"study.json", "front.svg"}) {  // and while the report is written
    std::filesystem::remove(out("study.json"));
    std::filesystem::remove(out("front.svg"));
    StartedRun run(study("out"), folder.path());
    ASSERT_TRUE(waitUntil([&] { return std::filesystem::exists(out(file)) || run.hasEnded(); }));
    run.send(SIGKILL);
    killed += run.wait().status == -SIGKILL;
    halves += broken();
  }
  EXPECT_GE(killed, 2);
  const Outcome last = run(study("out"));
  ASSERT_EQ(last.status, 0) << last.error;
  EXPECT_EQ(lines(), whole);
  expectAtMost("half files", halves + broken(), 0);
  expectAtMost("files that differ from an undisturbed study's", differences(), 0);
}

TEST_F(StoppedStudy, InterruptedTellsWhatItKept) {
  tell({"Trouble while running", "who interrupts a sweep does not know whether it was for nothing",
        "the message says how many drawings are kept, where, and that the same command goes on from there"});
  StartedRun run(study("out", "300"), folder.path());
  ASSERT_TRUE(waitUntil([&] { return lines() >= 12 || run.hasEnded(); }));
  run.send(SIGINT);
  const Outcome outcome = run.wait();
  EXPECT_EQ(outcome.status, 130);
  std::istringstream stored(contentOf(out("runs.jsonl")));
  std::ptrdiff_t visits = 0;
  for (std::string line; std::getline(stored, line);) visits += json::parse(line).contains("visit");
  const std::string told = std::to_string(visits) +
                           " drawings are kept in out/runs.jsonl: the same command (without --restart) goes on from "
                           "there\n";
  // A drawing may have got its line and not yet its word.
  const std::string before = std::to_string(visits - 1) + told.substr(told.find(' '));
  EXPECT_TRUE(outcome.error == "havs: interrupted; " + told || outcome.error == "havs: interrupted; " + before)
      << outcome.error;
  expectAtMost("half files", broken(), 0);
}

TEST_F(StoppedStudy, ItsFolderVanishes) {
  tell({"Trouble while running", "the folder of a study is removed while it runs",
        "the next picture cannot be written: status 1. The folder is not made again"});
  StartedRun run(study("out", "3"), folder.path());
  ASSERT_TRUE(waitUntil([&] { return lines() >= 4 || run.hasEnded(); }));
  std::filesystem::rename(folder / "out", folder / "moved");
  if (!waitUntil([&] { return run.hasEnded(); })) run.send(SIGKILL);
  const Outcome outcome = run.wait();
  EXPECT_THAT(outcome.error, HasSubstr("does not exist"));
  expectAtMost("status - 1", std::abs(outcome.status - 1), 0);
  EXPECT_FALSE(std::filesystem::exists(folder / "out"));
}

TEST_F(StoppedStudy, DiskFull) {
  tell({"Trouble while running", "a disk that is full breaks the line that is being written",
        "status 1, and the study goes on when there is room: the broken line is dropped"});
  int wrong = 0;
  for (const rlim_t bytes : {300, 2000, 4000, 9000}) {
    const Outcome outcome = run(study("out"), [&] {
      const rlimit limit{bytes, bytes};
      setrlimit(RLIMIT_FSIZE, &limit);
    });
    EXPECT_THAT(outcome.error, HasSubstr("writing failed"));
    wrong += outcome.status != 1;
  }
  const Outcome last = run(study("out"));
  EXPECT_EQ(last.status, 0) << last.error;
  expectAtMost("wrong ends", wrong, 0);
  expectAtMost("half files", broken(), 0);
  expectAtMost("files that differ from an undisturbed study's", differences(), 0);
}

}  // namespace
}  // namespace havs::test
