#include "tests/engine/support/traced_child.h"

#include <sys/ptrace.h>
#include <sys/syscall.h>
#include <sys/user.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>

namespace glissade::test {

#if defined(__x86_64__)

namespace {

[[noreturn]] void beTraced(const std::function<int()>& work) {
  if (::ptrace(PTRACE_TRACEME, 0, nullptr, nullptr) != 0) ::_exit(99);
  std::raise(SIGSTOP);
  ::_exit(work());
}

/// Runs the child to its next stop. False: there is none, because it ended.
bool resumeChild(pid_t child, int& status) {
  ::ptrace(PTRACE_SYSCALL, child, nullptr, nullptr);
  ::waitpid(child, &status, 0);
  return WIFSTOPPED(status);
}

bool isCallStop(int status) { return WSTOPSIG(status) == (SIGTRAP | 0x80); }

user_regs_struct registersOf(pid_t child) {
  user_regs_struct registers{};
  ::ptrace(PTRACE_GETREGS, child, nullptr, &registers);
  return registers;
}

/// The child stands at the beginning of a call. False: it has ended.
bool finishCall(pid_t child, const CallFate& fate, int& status) {
  user_regs_struct registers = registersOf(child);
  const bool fails = fate.kind == CallFate::Kind::Fails;
  if (fate.kind == CallFate::Kind::Kills) ::kill(child, SIGKILL);
  if (fails) {
    registers.orig_rax = static_cast<unsigned long long>(-1);  // no call has this number
    ::ptrace(PTRACE_SETREGS, child, nullptr, &registers);
  }
  if (!resumeChild(child, status)) return false;
  if (fails) {
    registers = registersOf(child);
    registers.rax = static_cast<unsigned long long>(-static_cast<long long>(fate.error));
    ::ptrace(PTRACE_SETREGS, child, nullptr, &registers);
  }
  return true;
}

/// Lets the child go on untraced, with the signal that it may have stopped for.
void letEnd(pid_t child, int& status) {
  while (WIFSTOPPED(status)) {
    const long signal = isCallStop(status) ? 0 : WSTOPSIG(status);
    ::ptrace(PTRACE_CONT, child, nullptr, signal);
    ::waitpid(child, &status, 0);
  }
}

}  // namespace

bool canTrace() {
  const TracedRun run = runTraced([] { return 7; }, [](std::size_t) { return CallFate(); });
  return run.exited && run.exitCode == 7;
}

TracedRun runTraced(const std::function<int()>& work, const std::function<CallFate(std::size_t)>& fate) {
  TracedRun run;
  const pid_t child = ::fork();
  if (child == 0) beTraced(work);
  int status = 0;
  ::waitpid(child, &status, 0);
  if (WIFSTOPPED(status)) ::ptrace(PTRACE_SETOPTIONS, child, nullptr, PTRACE_O_TRACESYSGOOD | PTRACE_O_EXITKILL);
  while (WIFSTOPPED(status) && resumeChild(child, status) && isCallStop(status)) {
    const auto number = static_cast<long>(registersOf(child).orig_rax);
    if (number == SYS_exit_group) break;
    const CallFate decided = fate(run.calls.size());
    run.calls.push_back(number);
    if (!finishCall(child, decided, status)) break;
  }
  letEnd(child, status);
  run.exited = WIFEXITED(status);
  run.exitCode = run.exited ? WEXITSTATUS(status) : -1;
  return run;
}

#else

bool canTrace() { return false; }

TracedRun runTraced(const std::function<int()>&, const std::function<CallFate(std::size_t)>&) { return {}; }

#endif

}  // namespace glissade::test
