#include "engine/import/sandbox.h"

#include <fcntl.h>
#include <seccomp.h>
#include <sys/prctl.h>
#include <sys/resource.h>

#include <cerrno>
#include <csignal>
#include <initializer_list>

namespace glissade {
namespace {

constexpr rlim_t kMostMemory = rlim_t{500} << 20;

bool limit(__rlimit_resource resource, rlim_t value) {
  const rlimit bound{value, value};
  return setrlimit(resource, &bound) == 0;
}

bool limitMemory() {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  return true;  // the sanitizers reserve terabytes of addresses for themselves
#else
  return limit(RLIMIT_AS, kMostMemory);
#endif
}

bool filterSystemCalls() {
  const scmp_filter_ctx filter = seccomp_init(SCMP_ACT_ERRNO(EPERM));
  if (!filter) return false;
  bool ok = true;
  for (const int call : {SCMP_SYS(read),          SCMP_SYS(write),     SCMP_SYS(lseek),        SCMP_SYS(close),
                         SCMP_SYS(fstat),         SCMP_SYS(brk),       SCMP_SYS(mmap),         SCMP_SYS(munmap),
                         SCMP_SYS(mremap),        SCMP_SYS(mprotect),  SCMP_SYS(madvise),      SCMP_SYS(futex),
                         SCMP_SYS(clock_gettime), SCMP_SYS(getrandom), SCMP_SYS(rt_sigaction), SCMP_SYS(rt_sigprocmask),
                         SCMP_SYS(rt_sigreturn),  SCMP_SYS(getpid),    SCMP_SYS(gettid),       SCMP_SYS(tgkill),
                         SCMP_SYS(exit),          SCMP_SYS(exit_group)}) {
    ok = ok && seccomp_rule_add(filter, SCMP_ACT_ALLOW, call, 0) == 0;
  }
  ok = ok && seccomp_load(filter) == 0;
  seccomp_release(filter);
  return ok;
}

}  // namespace

bool enterSandbox(unsigned cpuSeconds) {
  return prctl(PR_SET_PDEATHSIG, SIGKILL) == 0 && limitMemory() && limit(RLIMIT_CPU, cpuSeconds) &&
         limit(RLIMIT_CORE, 0) && filterSystemCalls();
}

}  // namespace glissade
