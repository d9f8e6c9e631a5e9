#pragma once
#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "support/temporary_folder.h"

namespace havs::test {

/// How a run of the built program ended.
struct Outcome {
  int status = 0;  ///< exit status; the negative signal when one ended it
  std::string output;
  std::string error;
};

/// What the child does before it becomes the program: limits, signals.
using Preparation = std::function<void()>;

/// `havs ARGUMENTS` in `folder`, without a terminal, running beside the test. Killed where it is not awaited.
class StartedRun {
 public:
  StartedRun(const std::vector<std::string>& arguments, const std::filesystem::path& folder,
             const Preparation& prepare = {}) {
    const std::string program = std::string(HAVS_BUILD) + "/bin/havs";
    const std::string output = streams_ / "output", error = streams_ / "error";
    std::vector<char*> argv{const_cast<char*>(program.c_str())};
    for (const std::string& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
    argv.push_back(nullptr);
    process_ = fork();
    if (process_ != 0) return;
    dup2(open(output.c_str(), O_CREAT | O_WRONLY | O_CLOEXEC, 0600), STDOUT_FILENO);
    dup2(open(error.c_str(), O_CREAT | O_WRONLY | O_CLOEXEC, 0600), STDERR_FILENO);
    if (chdir(folder.c_str()) != 0) _exit(126);
    if (prepare) prepare();
    execv(program.c_str(), argv.data());
    _exit(127);
  }
  ~StartedRun() {
    if (hasEnded()) return;
    send(SIGKILL);
    wait();
  }
  StartedRun(const StartedRun&) = delete;
  StartedRun& operator=(const StartedRun&) = delete;

  pid_t process() const { return process_; }
  void send(int signal) const { kill(process_, signal); }
  bool hasEnded() {
    ended_ = ended_ || waitpid(process_, &state_, WNOHANG) == process_;
    return ended_;
  }
  /// The end, and what was printed.
  Outcome wait() {
    if (!ended_) waitpid(process_, &state_, 0);
    ended_ = true;
    return {WIFEXITED(state_) ? WEXITSTATUS(state_) : -WTERMSIG(state_), contentOf(streams_ / "output"),
            contentOf(streams_ / "error")};
  }

 private:
  TemporaryFolder streams_;
  pid_t process_ = -1;
  int state_ = 0;
  bool ended_ = false;
};

/// Runs `havs ARGUMENTS` in `folder` to its end.
inline Outcome runHavs(const std::vector<std::string>& arguments, const std::filesystem::path& folder,
                       const Preparation& prepare = {}) {
  return StartedRun(arguments, folder, prepare).wait();
}

}  // namespace havs::test
