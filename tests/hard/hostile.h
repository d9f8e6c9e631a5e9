#pragma once
// Files and options that ask for what no machine has: the program as a whole, run in a process of its own, its memory
// measured.
#include <gmock/gmock.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <string>
#include <vector>

#include "cli/sample_files.h"
#include "hard/hard_case.h"
#include "support/sanitized.h"

namespace havs::test {

/// How a run of the program ended.
struct HostileRun {
  int status = 0;  ///< exit status; the negative signal when one ended it
  std::string output, error;
  double megabytes = 0;  ///< the most that it or a process that it started had in memory
};

/// Cases of the group "Hostile input", with a folder of their own that holds a sound mesh: cube.node, cube.ele.
class HostileTest : public HardTest {
 protected:
  HostileTest() { writeTetgenMesh(folder, "cube", kCubeNode, kCubeEle); }

  void tell(const std::string& trouble, const std::string& remedy) {
    HardTest::tell({"Hostile input", trouble, remedy});
  }

  HostileRun havs(std::vector<std::string> arguments) const {
    const TemporaryFolder streams;
    const std::string output = streams / "output", error = streams / "error";
    arguments.insert(arguments.begin(), std::string(HAVS_BUILD) + "/bin/havs");
    std::vector<char*> argv;
    for (std::string& argument : arguments) argv.push_back(argument.data());
    argv.push_back(nullptr);
    const pid_t child = fork();
    if (child == 0) {
      const bool ready = chdir(folder.path().c_str()) == 0 && std::freopen(output.c_str(), "w", stdout) != nullptr &&
                         std::freopen(error.c_str(), "w", stderr) != nullptr;
      if (ready) execv(argv[0], argv.data());
      _exit(127);
    }
    int state = 0;
    rusage usage{};
    wait4(child, &state, 0, &usage);
    return {WIFEXITED(state) ? WEXITSTATUS(state) : -WTERMSIG(state), contentOf(output), contentOf(error),
            static_cast<double>(usage.ru_maxrss) * 1024 / 1e6};
  }

  /// Expects exit status 2, one line of reason that holds `says`, and no more memory than `megabytes`.
  void expectRefused(const std::vector<std::string>& arguments, const std::string& says, double megabytes = 100) {
    const HostileRun run = havs(arguments);
    EXPECT_THAT(run.error, testing::StartsWith("havs: "));
    EXPECT_THAT(run.error, testing::HasSubstr(says));
    EXPECT_EQ(run.error.find('\n'), run.error.size() - 1) << "not one line: " << run.error;
    for (const char c : run.error) EXPECT_TRUE(static_cast<unsigned char>(c) >= ' ' || c == '\n') << int{c};
    wrong_ += run.status == 2 ? 0 : 1;
    EXPECT_EQ(run.status, 2) << run.error;
    expectAtMost("runs not refused", wrong_, 0);
    expectMemory(run, megabytes);
  }
  void expectRead(const std::vector<std::string>& arguments, double megabytes = 100) {
    const HostileRun run = havs(arguments);
    EXPECT_EQ(run.status, 0) << run.error;
    wrong_ += run.status == 0 ? 0 : 1;
    expectAtMost("runs that failed", wrong_, 0);
    expectMemory(run, megabytes);
  }

  TemporaryFolder folder;

 private:
  void expectMemory(const HostileRun& run, double megabytes) {
    if (!kSanitized) expectAtMost("memory, MB", run.megabytes, megabytes);
  }

  double wrong_ = 0;
};

}  // namespace havs::test
