#include "confinement.hpp"

#include <errno.h>
#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <signal.h>
#include <stddef.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>

#include <vector>

namespace lepp::gdal_helper {
namespace {

template <class Resource>
void limit(Resource resource, rlim_t most) {
  rlimit bound{};
  if (getrlimit(resource, &bound) != 0) return;
  if (bound.rlim_max != RLIM_INFINITY && bound.rlim_max < most) return;  // bound already
  bound.rlim_cur = bound.rlim_max = most;
  setrlimit(resource, &bound);
}

#if defined(__x86_64__)
constexpr unsigned architecture = AUDIT_ARCH_X86_64;
#elif defined(__aarch64__)
constexpr unsigned architecture = AUDIT_ARCH_AARCH64;
#else
constexpr unsigned architecture = 0;
#endif

const std::vector<long> forbidden = {
    SYS_socket, SYS_execve, SYS_execveat, SYS_unlinkat, SYS_renameat2, SYS_truncate, SYS_ftruncate,
#if defined(__x86_64__)
    SYS_unlink, SYS_rename, SYS_renameat, SYS_creat,
#endif
};

// A list of comparisons: each forbidden call fails, as if by the user's own missing permission.
// Where the system knows no such filter, the limits alone remain.
void filter_calls() {
  if (architecture == 0) return;
  const auto allow = static_cast<__u32>(SECCOMP_RET_ALLOW);
  const auto deny = static_cast<__u32>(SECCOMP_RET_ERRNO | EPERM);
  std::vector<sock_filter> program = {
      BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, arch)),
      BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, architecture, 1, 0), BPF_STMT(BPF_RET | BPF_K, deny),
      BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, nr))};
  for (const long call : forbidden) {
    program.push_back(BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, static_cast<__u32>(call), 0, 1));
    program.push_back(BPF_STMT(BPF_RET | BPF_K, deny));
  }
  program.push_back(BPF_STMT(BPF_RET | BPF_K, allow));
  sock_fprog filter{static_cast<unsigned short>(program.size()), program.data()};
  if (prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0) return;
  prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &filter);
}

}  // namespace

void confine(std::uint64_t cpu_seconds, std::uint64_t memory_bytes) {
  limit(RLIMIT_CORE, 0);
  limit(RLIMIT_CPU, cpu_seconds);
#if !defined(__SANITIZE_ADDRESS__)  // its shadow memory is larger than any bound
  limit(RLIMIT_AS, memory_bytes);
#else
  (void)memory_bytes;
#endif
  signal(SIGXFSZ, SIG_IGN);  // a write fails instead of ending the process; pipes are not files
  limit(RLIMIT_FSIZE, 0);
  filter_calls();
}

}  // namespace lepp::gdal_helper
