// SPDX-License-Identifier: GPL-2.0-or-later
#include "limits.hpp"

#include <signal.h>
#include <sys/resource.h>

namespace lepp::gmsh_helper {
namespace {

template <class Resource>
void limit(Resource resource, rlim_t most) {
  rlimit bound{};
  if (getrlimit(resource, &bound) != 0) return;
  if (bound.rlim_max != RLIM_INFINITY && bound.rlim_max < most) return;  // bound already
  bound.rlim_cur = bound.rlim_max = most;
  setrlimit(resource, &bound);
}

}  // namespace

void limit_resources(std::uint64_t cpu_seconds, std::uint64_t memory_bytes) {
  limit(RLIMIT_CORE, 0);
  limit(RLIMIT_CPU, cpu_seconds);
#if !defined(__SANITIZE_ADDRESS__)  // its shadow memory is larger than any bound
  limit(RLIMIT_AS, memory_bytes);
#else
  (void)memory_bytes;
#endif
}

void forbid_writing() {
  signal(SIGXFSZ, SIG_IGN);  // a write fails instead of ending the process; pipes are not files
  limit(RLIMIT_FSIZE, 0);
  limit(RLIMIT_NPROC, 0);
}

}  // namespace lepp::gmsh_helper
