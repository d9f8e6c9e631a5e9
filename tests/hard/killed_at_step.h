#pragma once
// A run that is killed at a chosen system call, so that no moment of writing a file is left to chance.
#include <fcntl.h>
#include <linux/ptrace.h>
#include <sys/ptrace.h>
#include <sys/syscall.h>

#include <set>

#include "cli/run_havs.h"

namespace havs::test {

/// Whether the call that a process is about to make changes files.
inline bool changesFiles(const __ptrace_syscall_info& call) {
  static const std::set<long> changes{SYS_fsync,     SYS_fdatasync, SYS_linkat,   SYS_rename,  SYS_renameat,
                                      SYS_renameat2, SYS_unlink,    SYS_unlinkat, SYS_mkdirat, SYS_ftruncate};
  static const std::set<long> writes{SYS_write, SYS_writev, SYS_pwrite64};
  const auto number = static_cast<long>(call.entry.nr);
  if (number == SYS_openat) return (call.entry.args[2] & (O_CREAT | O_TRUNC | (O_TMPFILE & ~O_DIRECTORY))) != 0;
  if (writes.contains(number)) return call.entry.args[0] > STDERR_FILENO;
  return changes.contains(number);
}

/// Kills the run before the call by which its main thread changes files for the `step`-th time, from 0. False: it came
/// to its end before. The run must have been prepared by traceMe.
inline bool killAtStep(const StartedRun& run, int step) {
  const pid_t process = run.process();
  constexpr int kOptions = PTRACE_O_TRACESYSGOOD | PTRACE_O_TRACEEXIT | PTRACE_O_EXITKILL;
  for (int state = 0, signal = 0; waitpid(process, &state, 0) == process && WIFSTOPPED(state);) {
    const int stop = WSTOPSIG(state);
    if (state >> 8 == (SIGTRAP | PTRACE_EVENT_EXIT << 8)) {
      ptrace(PTRACE_DETACH, process, nullptr, nullptr);
      return false;
    }
    if (stop == (SIGTRAP | 0x80)) {
      __ptrace_syscall_info call{};
      ptrace(static_cast<__ptrace_request>(PTRACE_GET_SYSCALL_INFO), process, sizeof call, &call);
      if (call.op == PTRACE_SYSCALL_INFO_ENTRY && changesFiles(call) && step-- == 0) {
        run.send(SIGKILL);
        return true;
      }
    } else if (stop == SIGTRAP) {
      ptrace(PTRACE_SETOPTIONS, process, nullptr, kOptions);  // it has become havs
    } else {
      signal = stop;
    }
    ptrace(PTRACE_SYSCALL, process, nullptr, signal);
    signal = 0;
  }
  return false;
}

inline void traceMe() { ptrace(PTRACE_TRACEME, 0, nullptr, nullptr); }

}  // namespace havs::test
