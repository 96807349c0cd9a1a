#include "engine/import/system_call_filter.h"

#include <seccomp.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cstring>
#include <memory>
#include <vector>

namespace glissade {
namespace {

struct Rule {
  int call;
  std::vector<scmp_arg_cmp> conditions;
};

scmp_arg_cmp equals(unsigned int argument, scmp_datum_t value) { return {argument, SCMP_CMP_EQ, value, 0}; }

/// True for a call whose argument has this value in the bits of the mask.
scmp_arg_cmp hasBits(unsigned int argument, scmp_datum_t mask, scmp_datum_t value) {
  return {argument, SCMP_CMP_MASKED_EQ, mask, value};
}

/// Permits only readable and writable memory: no code can be added.
scmp_arg_cmp isData(unsigned int argument) {
  return hasBits(argument, ~static_cast<scmp_datum_t>(PROT_READ | PROT_WRITE), 0);
}

std::vector<Rule> permitted() {
  std::vector<Rule> rules{
      {SCMP_SYS(read), {equals(0, kInputDescriptor)}},
      {SCMP_SYS(write), {equals(0, kOutputDescriptor)}},
      {SCMP_SYS(mmap), {isData(2), hasBits(3, MAP_ANONYMOUS, MAP_ANONYMOUS)}},
      {SCMP_SYS(mprotect), {isData(2)}},
      {SCMP_SYS(munmap), {}},
      {SCMP_SYS(mremap), {}},
      {SCMP_SYS(madvise), {}},
      {SCMP_SYS(brk), {}},
      {SCMP_SYS(futex), {}},
      {SCMP_SYS(clock_gettime), {}},
      {SCMP_SYS(clock_getres), {}},
      {SCMP_SYS(gettimeofday), {}},
      {SCMP_SYS(rt_sigreturn), {}},
      {SCMP_SYS(exit), {}},
      {SCMP_SYS(exit_group), {}},
  };
#ifdef GLISSADE_SANITIZED
  // Calls of the sanitizers' run-time libraries while the program runs, and for reports.
  rules.push_back({SCMP_SYS(write), {equals(0, STDERR_FILENO)}});
  for (const int call : {SCMP_SYS(getpid), SCMP_SYS(gettid), SCMP_SYS(sched_yield), SCMP_SYS(sigaltstack),
                         SCMP_SYS(rt_sigprocmask), SCMP_SYS(nanosleep), SCMP_SYS(clock_nanosleep)}) {
    rules.push_back({call, {}});
  }
#endif
  return rules;
}

/// libseccomp returns its errors as negative numbers of errno.
Diagnostic cannotLoad(int error) {
  return {ErrorKind::Internal,
          "",
          "",
          {GLISSADE_TEXT("the filter of system calls cannot be loaded: %1"), {std::strerror(-error)}},
          {}};
}

}  // namespace

Outcome loadSystemCallFilter() {
  const std::unique_ptr<void, void (*)(scmp_filter_ctx)> filter(seccomp_init(SCMP_ACT_ERRNO(EPERM)), seccomp_release);
  if (!filter) return cannotLoad(-ENOMEM);
  for (const auto& [attribute, value] :
       {std::pair(SCMP_FLTATR_ACT_BADARCH, SCMP_ACT_KILL_PROCESS), std::pair(SCMP_FLTATR_CTL_TSYNC, 1U)}) {
    if (const int error = seccomp_attr_set(filter.get(), attribute, value); error != 0) return cannotLoad(error);
  }
  for (const Rule& rule : permitted()) {
    const int error = seccomp_rule_add_array(filter.get(), SCMP_ACT_ALLOW, rule.call,
                                             static_cast<unsigned int>(rule.conditions.size()), rule.conditions.data());
    if (error != 0) return cannotLoad(error);
  }
  if (const int error = seccomp_load(filter.get()); error != 0) return cannotLoad(error);
  return Done{};
}

}  // namespace glissade
