// What fails while running: exit status 1, and still nothing half done.
#include "cli/refused.h"

namespace havs::test {
namespace {

using Failure = RefusedRun;

/// Files beyond 64 bytes cannot be written, as on a full disk.
void limitFiles() {
  std::signal(SIGXFSZ, SIG_IGN);
  const rlimit limit{64, 64};
  setrlimit(RLIMIT_FSIZE, &limit);
}

/// The limit cuts the reason short, too (standard error is a file here): its beginning is there.
TEST_F(Failure, FullDiskLeavesNoFile) {
  for (const char* output : {"a.png", "a.exr", "a.pfm"}) {
    const auto before = contentsOf(folder.path());
    const Outcome run = runHavs({"render", "cube.node", "--size", "64x64", "--table", "8", "-o", output, "--quiet"},
                                folder.path(), limitFiles);
    EXPECT_EQ(run.status, 1) << run.error;
    EXPECT_THAT(run.error, testing::StartsWith(std::string("havs: ") + output + ": writing failed"));
    EXPECT_EQ(contentsOf(folder.path()), before) << output;
  }
}

TEST_F(Failure, FullDiskKeepsTheOlderMesh) {
  folder.write("a.node", "older");
  folder.write("a.ele", "older");
  const auto before = contentsOf(folder.path());
  const Outcome run = runHavs({"mesh", "cube.node", "-o", "a.node", "--quiet"}, folder.path(), limitFiles);
  EXPECT_EQ(run.status, 1) << run.error;
  EXPECT_EQ(contentsOf(folder.path()), before);
  EXPECT_EQ(contentOf(folder / "a.node"), "older");
  EXPECT_EQ(contentOf(folder / "a.ele"), "older");
}

TEST_F(Failure, StandardOutputThatCannotBeWritten) {
  const Refused refused{"", {"info", "cube.node"}, "standard output", 1};
  expectRefused(refused, [] { dup2(open("/dev/full", O_WRONLY), STDOUT_FILENO); });
}

}  // namespace
}  // namespace havs::test
