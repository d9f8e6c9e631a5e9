#pragma once
// A run that is killed at a chosen system call, so that no moment of writing a file is left to chance.
#include <fcntl.h>
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
  for (int signal = 0;; signal = 0) {
    siginfo_t end{};  // which is left for run.wait()
    if (waitid(P_PID, static_cast<id_t>(process), &end, WEXITED | WSTOPPED | WNOWAIT) != 0) return false;
    if (end.si_code == CLD_EXITED || end.si_code == CLD_KILLED || end.si_code == CLD_DUMPED) return false;
    int state = 0;
    waitpid(process, &state, 0);
    const int stop = WSTOPSIG(state);
    if (stop == (SIGTRAP | 0x80)) {
      __ptrace_syscall_info call{};
      ptrace(PTRACE_GET_SYSCALL_INFO, process, sizeof call, &call);
      if (call.op == PTRACE_SYSCALL_INFO_ENTRY && changesFiles(call) && step-- == 0) {
        run.send(SIGKILL);
        return true;
      }
    } else if (stop == SIGTRAP) {  // it has become havs
      ptrace(PTRACE_SETOPTIONS, process, nullptr, PTRACE_O_TRACESYSGOOD | PTRACE_O_EXITKILL);
    } else {
      signal = stop;
    }
    ptrace(PTRACE_SYSCALL, process, nullptr, signal);
  }
}

inline void traceMe() {
  setenv("LSAN_OPTIONS", "detect_leaks=0", 1);  // it traces itself, and a process has one tracer
  ptrace(PTRACE_TRACEME, 0, nullptr, nullptr);
}

}  // namespace havs::test
