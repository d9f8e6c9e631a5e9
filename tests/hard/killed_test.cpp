// kill -9: nothing can be done any more, so nothing may have to be.
#include <algorithm>
#include <map>

#include "hard/denied_calls.h"
#include "hard/killed_at_step.h"
#include "hard/trouble.h"

namespace havs::test {
namespace {

class Killed : public TroubleTest {
 protected:
  const std::vector<std::string> render_{"render", "cube.node", "--size", "64x64", "--table", "16", "--quiet"};

  std::vector<std::string> into(const std::string& file) const {
    std::vector<std::string> arguments = render_;
    arguments.insert(arguments.end(), {"-o", file});
    return arguments;
  }

  struct Left {
    int kills = 0, broken = 0, hidden = 0, after = 0;
  };
  /// Kills before each call that changes files, until the run comes to its end; then lets one run undisturbed.
  Left killAtEachStep(const std::string& file, const std::string& older, const Preparation& prepare) {
    Left left;
    const std::string whole = undisturbed(render_, std::filesystem::path(file).extension());
    for (bool killed = true; killed; left.kills += killed) {
      if (older.empty())
        std::filesystem::remove(folder / file);
      else
        folder.write(file, older);
      StartedRun run(into(file), folder.path(), [&] {
        if (prepare) prepare();
        traceMe();
      });
      killed = killAtStep(run, left.kills);
      EXPECT_EQ(run.wait().status, killed ? -SIGKILL : 0);
      for (const auto& [name, content] : files()) {
        if (name == file)
          left.broken += content != whole && content != older;
        else
          left.hidden = std::max(left.hidden, static_cast<int>(files().size()) - 1);
      }
    }
    EXPECT_EQ(run(into(file)).status, 0);
    left.after = static_cast<int>(files().size()) - 1;
    EXPECT_EQ(files()[file], whole);
    std::filesystem::remove(folder / file);
    return left;
  }
};

TEST_F(Killed, RenderAtTenMoments) {
  tell({"Trouble while running", "a picture half written looks like a picture",
        "the picture is a file without a name (O_TMPFILE) until it is whole"});
  const auto start = std::chrono::steady_clock::now();
  const std::string png = undisturbed(render_), exr = undisturbed(render_, ".exr");
  const double seconds = secondsSince(start) / 2;
  constexpr int kMoments = 10;
  int killed = 0, broken = 0, others = 0;
  for (int i = 1; i <= kMoments; ++i) {
    StartedRun run({"render", "cube.node", "--size", "64x64", "--table", "16", "-o", "a.png", "-o", "a.exr"},
                   folder.path());
    usleep(static_cast<useconds_t>(1e6 * seconds * i / kMoments));
    run.send(SIGKILL);
    killed += run.wait().status == -SIGKILL;
    for (const auto& [name, content] : files()) {
      broken += (name == "a.png" && content != png) || (name == "a.exr" && content != exr);
      others += name != "a.png" && name != "a.exr";
      std::filesystem::remove(folder / name);
    }
  }
  EXPECT_GE(killed, 1);
  expectAtMost("half files", broken, 0);
  expectAtMost("files left beside them", others, 0);
}

TEST_F(Killed, AtEachStepOfWriting) {
  tell({"Trouble while running",
        "between any two system calls a process may be killed; a file written aside stays there",
        "the file gets its name by one call (linkat), when it is whole and on the disk"});
  for (const char* file : {"a.png", "a.exr", "a.pfm"}) {
    const Left left = killAtEachStep(file, "", {});
    EXPECT_GE(left.kills, 5) << file;
    expectAtMost("half files", left.broken, 0);
    expectAtMost("files left beside them", left.hidden, 0);
  }
}

TEST_F(Killed, AtEachStepOfReplacingAFile) {
  tell(
      {"Trouble while running", "a picture that is drawn again is neither the old nor the new one for a moment",
       "renamed over the older file. Only a file with a name can be: killed between the two calls it stays, whole, and "
       "the next run that writes this picture removes it, as its lock is gone"});
  const Left left = killAtEachStep("a.png", "the older picture", {});
  EXPECT_GE(left.kills, 6);
  expectAtMost("neither old nor new", left.broken, 0);
  expectAtMost("files left beside it", left.hidden, 1);
  expectAtMost("after the next run", left.after, 0);
}

TEST_F(Killed, WhereFilesNeedAName) {
  tell({"Trouble while running", "NFS and FUSE have no files without a name",
        "there it is written aside, locked; what a killed run left has lost its lock, and the next run removes it"});
  for (const char* older : {"", "the older picture"}) {
    const Left left = killAtEachStep("a.png", older, denyNamelessFiles);
    EXPECT_GE(left.kills, 5);
    expectAtMost("half files", left.broken, 0);
    expectAtMost("files left beside them", left.hidden, 1);
    expectAtMost("after the next run", left.after, 0);
  }
}

TEST_F(Killed, ARunThatStillWritesKeepsItsFile) {
  tell({"Trouble while running", "a run that tidies up could take a living run's file for a dead one's",
        "the file is locked as long as its run lives"});
  const std::string whole = undisturbed(render_);
  int taken = 0;
  for (const Preparation& prepare : {Preparation{}, Preparation(denyNamelessFiles)}) {
    folder.write("a.png", "the older picture");
    StartedRun stopped(into("a.png"), folder.path(), prepare);
    while (!stopped.hasEnded()) {  // in small steps, another run between any two
      stopped.send(SIGSTOP);
      taken += run(into("a.png")).status != 0;
      stopped.send(SIGCONT);
      usleep(4000);
    }
    taken += stopped.wait().status != 0;
    taken += files() != std::map<std::string, std::string>{{"a.png", whole}};
  }
  expectAtMost("runs that lost their file", taken, 0);
}

#if HAVS_WITH_TETGEN
TEST_F(Killed, ItsChildrenDieToo) {
  tell({"Trouble while running", "TetGen works for minutes in a process of its own, which nobody would end",
        "the kernel ends it with its parent (PR_SET_PDEATHSIG)"});
  StartedRun run({"mesh", HAVS_MESHES "/bracket.poly", "--tetgen", "pq1.2a0.0000001", "-o", "a.vtu"}, folder.path());
  pid_t child = 0;
  ASSERT_TRUE(waitUntil([&] { return (child = childOf(run.process())) != 0 || run.hasEnded(); }));
  ASSERT_NE(child, 0) << run.wait().error;
  run.send(SIGKILL);
  EXPECT_EQ(run.wait().status, -SIGKILL);
  const bool ended = waitUntil([&] { return !isRunning(child); });
  expectAtMost("children left", ended ? 0 : 1, 0);
  expectAtMost("files left", static_cast<double>(files().size()), 0);
}
#endif

}  // namespace
}  // namespace havs::test
