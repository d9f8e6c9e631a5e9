// Signals that ask the program to end, and streams that nobody listens to.
#include <map>
#include <nlohmann/json.hpp>

#include "hard/denied_calls.h"
#include "hard/trouble.h"
#include "support/sanitized.h"

namespace havs::test {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

class Interrupted : public TroubleTest {
 protected:
  /// Of a run that takes long: thousands of drawings of one picture, about a minute.
  const std::vector<std::string> long_{"render", "cube.node", "--size",  "256x256", "--table",
                                       "16",     "--repeat",  "1000000", "-o",      "a.png"};

  /// It has worked for 50 ms, on however many threads, or is gone. A sanitizer takes as long to start.
  static bool isWorking(const StartedRun& run) {
    const std::string stat = contentOf("/proc/" + std::to_string(run.process()) + "/stat");
    if (stat.empty()) return true;
    std::istringstream fields(stat.substr(stat.rfind(')') + 2));
    std::vector<std::string> words{std::istream_iterator<std::string>(fields), {}};
    constexpr std::size_t kUser = 11, kSystem = 12;  // fields 14 and 15, counted from the state, the third
    const long ticks = std::stol(words.at(kUser)) + std::stol(words.at(kSystem));
    constexpr long kPerSecond = kSanitized ? 1 : 20;
    return kPerSecond * ticks >= sysconf(_SC_CLK_TCK);
  }
  /// Sends the signal to a run that works; how it ends. Its time is a measure, and no test fails on it.
  Outcome interrupt(StartedRun& run, int signal) {
    const auto start = std::chrono::steady_clock::now();
    run.send(signal);
    if (!waitUntil([&] { return run.hasEnded(); })) run.send(SIGKILL);
    expectAtMost("seconds to the end (1 is promised of a machine that is free)", secondsSince(start), kHangSeconds);
    return run.wait();
  }
};

TEST_F(Interrupted, AtCtrlC) {
  tell(
      {"Trouble while running",
       "a program that ends at once leaves half files; one that waits for its loops does not "
       "end at once",
       "one thread waits for the signals of all; it removes what has no place yet, tells what is written, and ends the "
       "process: status 130"});
  StartedRun run(long_, folder.path());
  ASSERT_TRUE(waitUntil([&] { return isWorking(run); }));
  const Outcome outcome = interrupt(run, SIGINT);
  EXPECT_EQ(outcome.status, 130);
  EXPECT_EQ(outcome.error, "havs: interrupted; nothing was written\n");
  expectAtMost("files left", static_cast<double>(files().size()), 0);
}

TEST_F(Interrupted, EveryWayToAskForTheEnd) {
  tell({"Trouble while running", "a batch system asks by SIGTERM, a closed terminal by SIGHUP",
        "treated as Ctrl-C: status 128 + signal, the reason in the message; also on OpenGL, whose threads are Mesa's"});
  int wrong = 0;
  for (const auto& [signal, reason] :
       std::map<int, std::string>{{SIGHUP, "the terminal has gone"}, {SIGINT, "interrupted"}, {SIGTERM, "terminated"}})
    for (const std::string device : {"native", "osmesa"}) {
      std::vector<std::string> arguments = long_;
      arguments.insert(arguments.end(), {"--device", device});
      StartedRun run(arguments, folder.path());
      ASSERT_TRUE(waitUntil([&] { return isWorking(run); }));
      const Outcome outcome = interrupt(run, signal);
      EXPECT_THAT(outcome.error, StartsWith("havs: " + reason + "; nothing was written"));
      wrong += outcome.status != 128 + signal;
    }
  expectAtMost("ends with another status", wrong, 0);
  expectAtMost("files left", static_cast<double>(files().size()), 0);
}

TEST_F(Interrupted, SaysWhichPicturesAreWhole) {
  tell({"Trouble while running", "of many pictures nobody knows which are whole",
        "the message names those that have their place; the others are not there"});
  nlohmann::json scene{{"version", 1}, {"mesh", "cube.node"}, {"size", {256, 256}}, {"table", 8}};
  constexpr int kViews = 60;
  for (int i = 0; i < kViews; ++i)
    scene["views"].push_back({{"camera", {{"azimuth", i}}}, {"outputs", {std::to_string(i) + ".exr"}}});
  folder.write("cube.json", scene.dump());
  StartedRun run({"render", "cube.json", "--quiet"}, folder.path());
  ASSERT_TRUE(waitUntil([&] { return std::filesystem::exists(folder / "1.exr") || run.hasEnded(); }));
  const Outcome outcome = interrupt(run, SIGINT);
  const auto left = files();
  EXPECT_TRUE(outcome.status == 130 || (outcome.status == 0 && left.size() == kViews)) << outcome.error;
  if (outcome.status == 130) {
    EXPECT_THAT(outcome.error, StartsWith("havs: interrupted; written whole: 0.exr, 1.exr"));
  }
  int broken = 0, unnamed = 0;
  for (const auto& [name, content] : left) {
    if (!name.ends_with(".exr")) continue;
    EXPECT_EQ(readImage(folder / name).width, 256);
    broken += content.empty();
    unnamed += outcome.status == 130 && left.size() < 8 && outcome.error.find(name) == std::string::npos;
  }
  expectAtMost("half files", broken, 0);
  expectAtMost("whole files that are not named", unnamed, 0);
}

TEST_F(Interrupted, WhatIsIgnoredStaysIgnored) {
  tell({"Trouble while running",
        "nohup and a shell's background jobs let a program ignore signals; one that waits for "
        "them takes them all the same",
        "what is ignored at the start is not waited for"});
  StartedRun run(
      {"render", "cube.node", "--size", "64x64", "--table", "16", "--repeat", "50", "--quiet", "-o", "a.png"},
      folder.path(), [] {
        std::signal(SIGHUP, SIG_IGN);
        std::signal(SIGINT, SIG_IGN);
      });
  ASSERT_TRUE(waitUntil([&] { return isWorking(run) || run.hasEnded(); }));
  run.send(SIGHUP);
  run.send(SIGINT);
  const Outcome outcome = run.wait();
  EXPECT_EQ(outcome.error, "");
  expectAtMost("status", outcome.status, 0);
  EXPECT_EQ(files().size(), 1u);
}

#if HAVS_WITH_TETGEN
TEST_F(Interrupted, WhileTetgenWorks) {
  tell({"Trouble while running", "the process that is interrupted waits for another one",
        "the thread that waits for signals is not the one that waits for TetGen; both processes end"});
  StartedRun run({"mesh", HAVS_MESHES "/bracket.poly", "--tetgen", "pq1.2a0.0000001", "-o", "a.vtu"}, folder.path());
  pid_t child = 0;
  ASSERT_TRUE(waitUntil([&] { return (child = childOf(run.process())) != 0 || run.hasEnded(); }));
  ASSERT_NE(child, 0) << run.wait().error;
  const Outcome outcome = interrupt(run, SIGINT);
  EXPECT_EQ(outcome.status, 130);
  EXPECT_EQ(outcome.error, "havs: interrupted; nothing was written\n");
  expectAtMost("children left", waitUntil([&] { return !isRunning(child); }) ? 0 : 1, 0);
  expectAtMost("files left", static_cast<double>(files().size()), 0);
}
#endif

TEST_F(Interrupted, WhileItsFileHasAName) {
  tell({"Trouble while running", "where files need a name, a stop leaves the one that is being written",
        "the thread that stops the process knows the names and removes them"});
  int left = 0, ended = 0;
  constexpr int kMoments = 4;
  const auto hasHidden = [&] {
    const auto all = files();
    return std::any_of(all.begin(), all.end(), [](const auto& file) { return file.first.starts_with("."); });
  };
  for (int i = 0; i < kMoments; ++i) {
    StartedRun run({"render", "cube.node", "--size", "1000x1000", "--table", "16", "-o", "a.exr", "--quiet"},
                   folder.path(), denyNamelessFiles);
    ASSERT_TRUE(waitUntil([&] { return (isWorking(run) && hasHidden()) || run.hasEnded(); }));
    const Outcome outcome = interrupt(run, SIGTERM);
    EXPECT_TRUE(outcome.status == 143 || outcome.status == 0) << outcome.status << outcome.error;
    ended += outcome.status == 143;
    for (const auto& [name, content] : files()) left += name != "a.exr";
    std::filesystem::remove(folder / "a.exr");
  }
  EXPECT_GE(ended, 1);
  expectAtMost("files left", left, 0);
}

TEST_F(Interrupted, NobodyReadsItsMessage) {
  tell({"Trouble while running", "who writes to a full pipe waits for its reader, for ever where that one waits too",
        "the last words are written if they can be at once"});
  int pipe[2];
  ASSERT_EQ(::pipe2(pipe, O_CLOEXEC | O_NONBLOCK), 0);
  const std::string block(4096, ' ');
  while (write(pipe[1], block.data(), block.size()) > 0) {
  }
  fcntl(pipe[1], F_SETFL, 0);  // havs must not find it made easy
  StartedRun run(long_, folder.path(), [&] { dup2(pipe[1], STDERR_FILENO); });
  ASSERT_TRUE(waitUntil([&] { return isWorking(run); }));
  expectAtMost("status - 130", std::abs(interrupt(run, SIGINT).status - 130), 0);
  close(pipe[0]);
  close(pipe[1]);
}

TEST_F(Interrupted, ReaderOfItsOutputIsGone) {
  tell({"Trouble while running",
        "`havs ... | head` ends the program (SIGPIPE) after a page of text: here the pictures "
        "that were to be written after it were missing",
        "all files are written before the first word is printed"});
  nlohmann::json scene{{"version", 1}, {"mesh", "cube.node"}, {"size", {16, 16}}, {"table", 8}};
  constexpr int kViews = 40;
  for (int i = 0; i < kViews; ++i)
    scene["views"].push_back({{"camera", {{"azimuth", i}}}, {"outputs", {std::to_string(i) + ".png"}}});
  folder.write("cube.json", scene.dump());
  int pipe[2];
  ASSERT_EQ(::pipe2(pipe, O_CLOEXEC), 0);
  close(pipe[0]);
  const Outcome outcome = run({"render", "cube.json"}, [&] { dup2(pipe[1], STDOUT_FILENO); });
  close(pipe[1]);
  EXPECT_TRUE(outcome.status == -SIGPIPE || outcome.status == 1) << outcome.status;
  expectAtMost("pictures missing", kViews - static_cast<double>(files().size()), 0);
}

TEST_F(Interrupted, ClosedStreams) {
  tell({"Trouble while running",
        "a program started with standard output closed gives its number to the next file it "
        "opens: what it prints lands in a picture",
        "closed streams get /dev/null, opened so that printing fails and is told"});
  const std::vector<std::string> arguments{"render", "cube.node", "--size", "32x32", "--table", "16"};
  const std::string whole = undisturbed(arguments);
  int wrong = 0, status = 0;
  for (unsigned closed = 1; closed < 8; ++closed)
    for (const bool quiet : {true, false}) {
      std::vector<std::string> all = arguments;
      all.insert(all.end(), {"-o", "a.png"});
      if (quiet) all.push_back("--quiet");
      const Outcome outcome = run(all, [closed] {
        for (int stream = 0; stream < 3; ++stream)
          if ((closed >> stream & 1) != 0) close(stream);
      });
      const bool canPrint = (closed & 2) == 0;
      status += outcome.status != (quiet || canPrint ? 0 : 1);
      if (!quiet && !canPrint && (closed & 4) == 0) {
        EXPECT_THAT(outcome.error, HasSubstr("standard output cannot be written"));
      }
      wrong += files()["a.png"] != whole;
      std::filesystem::remove(folder / "a.png");
    }
  expectAtMost("wrong pictures", wrong, 0);
  expectAtMost("wrong statuses", status, 0);
}

}  // namespace
}  // namespace havs::test
