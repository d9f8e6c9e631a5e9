#include "app/signals.h"

#include <fcntl.h>
#include <poll.h>
#include <pthread.h>
#include <sys/resource.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <string>
#include <string_view>

#include "app/report_failure.h"
#include "core/sanitized.h"
#include "core/stopping.h"

namespace havs {
namespace {

struct Ending {
  int signal;
  const char* what;
};
constexpr std::array kEndings{Ending{SIGHUP, "the terminal has gone"}, Ending{SIGINT, "interrupted"},
                              Ending{SIGTERM, "terminated"}};

bool isIgnored(int signal) {
  struct sigaction action {};
  return sigaction(signal, nullptr, &action) == 0 && action.sa_handler == SIG_IGN;
}

sigset_t endingSignals() {
  sigset_t set;
  sigemptyset(&set);
  for (const Ending& ending : kEndings)
    if (!isIgnored(ending.signal)) sigaddset(&set, ending.signal);
  return set;
}

/// Writes if it can be written at once: a reader that does not read must not keep the process.
void tellAtOnce(std::string_view text) {
  pollfd stream{STDERR_FILENO, POLLOUT, 0};
  if (poll(&stream, 1, 0) != 1 || (stream.revents & POLLOUT) == 0) return;
  if (write(STDERR_FILENO, text.data(), text.size()) < 0) return;  // there is nobody else to tell
}

/// The thread that waits for the signals in place of all others, so that no work is done inside a handler.
void* waitForSignals(void*) {
  const sigset_t set = endingSignals();
  int signal = 0;
  while (sigwait(&set, &signal) != 0) {
  }
  const char* what = "";
  for (const Ending& ending : kEndings)
    if (ending.signal == signal) what = ending.what;
  const std::string left = stopProcess();
  tellAtOnce((isatty(STDERR_FILENO) ? "\nhavs: " : "havs: ") + std::string(what) + "; " + left + "\n");
  _exit(128 + signal);
}

#ifndef HAVS_SANITIZED
constexpr std::array kCrashes{SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT};

bool isMemoryLimited() {
  for (const auto limit : {RLIMIT_AS, RLIMIT_DATA}) {
    rlimit value{};
    if (getrlimit(limit, &value) == 0 && value.rlim_cur != RLIM_INFINITY) return true;
  }
  return false;
}

/// Only what may be called inside a handler. Of several threads that crash at once, one tells.
void onCrash(int signal) {
  static std::atomic_flag told;
  if (told.test_and_set())
    while (true) pause();
  tellAtOnce("havs: crashed (");
  tellAtOnce(sigdescr_np(signal));
  if (isMemoryLimited()) {
    tellAtOnce("), most likely out of memory; raise its limit (ulimit -v, -d), or try --device native\n");
    _exit(1);
  }
  tellAtOnce("); please report it with the command line\n");
  std::signal(signal, SIG_DFL);
  raise(signal);  // comes when the handler returns
}
#endif

/// An exception that nothing can pass on: oneTBB throws, where no thread can be started, through functions that must
/// not.
[[noreturn]] void onTerminate() {
  if (std::current_exception()) _exit(reportFailure());
  std::abort();
}

}  // namespace

void keepStandardStreams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    if (fcntl(stream, F_GETFD) < 0) open("/dev/null", O_RDONLY);  // takes the lowest free number: this one
}

void stopOnSignals() {
  std::signal(SIGXFSZ, SIG_IGN);
  const sigset_t set = endingSignals();
  pthread_sigmask(SIG_BLOCK, &set, nullptr);
  constexpr std::size_t kStack = 256 << 10;  // the usual 8 MiB would count where address space is limited
  pthread_attr_t attributes;
  pthread_attr_init(&attributes);
  pthread_attr_setstacksize(&attributes, kStack);
  pthread_attr_setdetachstate(&attributes, PTHREAD_CREATE_DETACHED);
  pthread_t thread{};
  const bool waits = pthread_create(&thread, &attributes, waitForSignals, nullptr) == 0;
  pthread_attr_destroy(&attributes);
  if (!waits) pthread_sigmask(SIG_UNBLOCK, &set, nullptr);  // then they end the process as they do without us
}

void tellOfCrashes() {
  std::set_terminate(onTerminate);
#ifndef HAVS_SANITIZED
  for (const int crash : kCrashes) {
    struct sigaction action {};
    action.sa_handler = onCrash;
    sigaction(crash, &action, nullptr);
  }
#endif
}

}  // namespace havs
