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

/// Runs `havs ARGUMENTS` in `folder`, without a terminal.
inline Outcome runHavs(const std::vector<std::string>& arguments, const std::filesystem::path& folder,
                       const Preparation& prepare = {}) {
  const TemporaryFolder streams;
  const std::string output = streams / "output";
  const std::string error = streams / "error";
  const std::string program = std::string(HAVS_BUILD) + "/bin/havs";
  std::vector<char*> argv{const_cast<char*>(program.c_str())};
  for (const std::string& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
  argv.push_back(nullptr);
  const pid_t child = fork();
  if (child == 0) {
    dup2(open(output.c_str(), O_CREAT | O_WRONLY, 0600), STDOUT_FILENO);
    dup2(open(error.c_str(), O_CREAT | O_WRONLY, 0600), STDERR_FILENO);
    if (chdir(folder.c_str()) != 0) _exit(126);
    if (prepare) prepare();
    execv(program.c_str(), argv.data());
    _exit(127);
  }
  int state = 0;
  waitpid(child, &state, 0);
  return {WIFEXITED(state) ? WEXITSTATUS(state) : -WTERMSIG(state), contentOf(output), contentOf(error)};
}

}  // namespace havs::test
