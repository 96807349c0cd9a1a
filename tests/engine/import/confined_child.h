#pragma once

#include <fcntl.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <string>

#include "engine/import/system_call_filter.h"

namespace glissade::test {

/// The output of a forked child to kOutputDescriptor, and its end (a status of waitpid).
struct ChildReport {
  std::string text;
  int status = 0;

  bool exited() const { return WIFEXITED(status) && WEXITSTATUS(status) == 0; }
  int signal() const { return WIFSIGNALED(status) ? WTERMSIG(status) : 0; }
};

/// Writes to the parent. All six arguments are given, because filters may examine arguments that a call does not have.
inline void say(const std::string& text) {
  ::syscall(SYS_write, kOutputDescriptor, text.data(), text.size(), 0L, 0L, 0L);
}

[[noreturn]] inline void end(long exitCode) {
  while (true) ::syscall(SYS_exit_group, exitCode, 0L, 0L, 0L, 0L, 0L);
}

/// Runs `work` in a forked child with the descriptors of an importing process: an empty input, and kOutputDescriptor,
/// to which `say` writes. The rest of the test program does not run in the child.
template <class Work>
ChildReport reportOf(const Work& work) {
  std::array<int, 2> pipe{};
  if (::pipe(pipe.data()) != 0) return {"no pipe", -1};
  const pid_t pid = ::fork();
  if (pid == 0) {
    const int empty = ::open("/dev/null", O_RDONLY);
    ::dup2(empty, kInputDescriptor);
    ::dup2(pipe[1], kOutputDescriptor);
    ::close_range(kOutputDescriptor + 1, ~0U, 0);
    work();
    end(0);
  }
  ::close(pipe[1]);
  ChildReport report;
  std::array<char, 4096> buffer{};
  ssize_t count = 0;
  while ((count = ::read(pipe[0], buffer.data(), buffer.size())) > 0) {
    report.text.append(buffer.data(), static_cast<std::size_t>(count));
  }
  ::close(pipe[0]);
  ::waitpid(pid, &report.status, 0);
  return report;
}

}  // namespace glissade::test
