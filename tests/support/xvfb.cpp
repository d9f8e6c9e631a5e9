#include "support/xvfb.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdlib>
#include <stdexcept>

namespace havs {

namespace {

constexpr int kStartMilliseconds = 20000;

[[noreturn]] void becomeXvfb(int displayPipe) {
  prctl(PR_SET_PDEATHSIG, SIGTERM);  // ends with a test that crashes
  const int null = open("/dev/null", O_RDWR);
  dup2(null, STDOUT_FILENO);
  dup2(null, STDERR_FILENO);
  const std::string number = std::to_string(displayPipe);
  // -noreset: it stays when the last window goes, so that the next finds it ready.
  execlp("Xvfb", "Xvfb", "-displayfd", number.c_str(), "-screen", "0", "640x480x24", "-nolisten", "tcp", "-noreset",
         nullptr);
  _exit(127);
}

/// The number that Xvfb writes once it is ready; empty where it ends or is silent.
std::string readDisplayNumber(int pipe) {
  std::string number;
  for (pollfd ready{pipe, POLLIN, 0}; poll(&ready, 1, kStartMilliseconds) > 0;) {
    char c = 0;
    if (read(pipe, &c, 1) != 1) return "";
    if (c == '\n') return number;
    number += c;
  }
  return "";
}

void end(pid_t pid) {
  kill(pid, SIGTERM);
  waitpid(pid, nullptr, 0);
}

}  // namespace

Xvfb::Xvfb() {
  std::array<int, 2> ends{};
  if (pipe(ends.data()) != 0) throw std::runtime_error("no pipe for Xvfb");
  pid_ = fork();
  if (pid_ == 0) becomeXvfb(ends[1]);
  close(ends[1]);
  const std::string number = pid_ > 0 ? readDisplayNumber(ends[0]) : "";
  close(ends[0]);
  if (number.empty()) {
    if (pid_ > 0) end(pid_);
    throw std::runtime_error("Xvfb does not start; Debian: apt install xvfb");
  }
  if (const char* display = std::getenv("DISPLAY")) formerDisplay_ = display;
  setenv("DISPLAY", (":" + number).c_str(), 1);
}

Xvfb::~Xvfb() {
  if (formerDisplay_) {
    setenv("DISPLAY", formerDisplay_->c_str(), 1);
  } else {
    unsetenv("DISPLAY");
  }
  end(pid_);
}

}  // namespace havs
