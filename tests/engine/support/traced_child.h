#pragma once

#include <functional>
#include <vector>

namespace glissade::test {

/// The result of one system call of a traced child.
struct CallFate {
  enum class Kind { Passes, Fails, Kills } kind = Kind::Passes;
  int error = 0;  ///< errno that a failing call gives; the system does not carry it out
};

struct TracedRun {
  std::vector<long> calls;  ///< the numbers of the system calls, in order
  bool exited = false;      ///< else a signal has ended the child
  int exitCode = -1;
};

/// Whether this machine and processor let a child be traced.
bool canTrace();

/// Runs `work` in a forked child and decides at each of its system calls, counted from 0. The exit of the
/// child is no such call. `work` gives the exit code.
TracedRun runTraced(const std::function<int()>& work, const std::function<CallFate(std::size_t)>& fate);

}  // namespace glissade::test
