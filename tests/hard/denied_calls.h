#pragma once
// System calls that the kernel refuses a process: what a machine has not, or has no more of. For any user, not for root
// alone, as a seccomp filter may be set by who gives up new privileges.
#include <fcntl.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sched.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace havs::test {

/// A call is refused with `error` where (argument `argument` & mask) == mask; mask 0: always.
struct DeniedCall {
  long number;
  int error;
  unsigned argument = 0;
  std::uint32_t mask = 0;
};

/// For this process and what it becomes. False where the kernel has no filters.
inline bool denyCalls(const std::vector<DeniedCall>& calls) {
  std::vector<sock_filter> code;
  const auto load = [&](std::size_t offset) {
    code.push_back(BPF_STMT(BPF_LD | BPF_W | BPF_ABS, static_cast<std::uint32_t>(offset)));
  };
  for (const DeniedCall& call : calls) {
    load(offsetof(seccomp_data, nr));
    code.push_back(BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, static_cast<std::uint32_t>(call.number), 0, 4));
    load(offsetof(seccomp_data, args) + 8 * call.argument);  // its lower half, on a little-endian machine
    code.push_back(BPF_STMT(BPF_ALU | BPF_AND | BPF_K, call.mask));
    code.push_back(BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, call.mask, 0, 1));
    code.push_back(BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ERRNO | static_cast<std::uint32_t>(call.error)));
  }
  code.push_back(BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW));
  const sock_fprog program{static_cast<unsigned short>(code.size()), code.data()};
  return prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0 && prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &program) == 0;
}

/// The file system has no files without a name.
inline void denyNamelessFiles() {
  if (!denyCalls({{SYS_openat, EOPNOTSUPP, 2, O_TMPFILE}})) _exit(125);
}

/// No thread can be started (processes can): as at the limit of processes.
inline void denyThreads() {
  if (!denyCalls({{SYS_clone3, ENOSYS}, {SYS_clone, EAGAIN, 0, CLONE_THREAD}})) _exit(125);
}

}  // namespace havs::test
