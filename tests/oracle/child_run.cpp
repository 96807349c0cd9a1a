#include "tests/oracle/child_run.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <csignal>
#include <stdexcept>

namespace glissade::oracle {
namespace {

using Clock = std::chrono::steady_clock;
constexpr std::size_t kMostKept = 1U << 20;

[[noreturn]] void execute(const std::vector<std::string>& command, int output, int errors) {
  ::setpgid(0, 0);
  ::dup2(::open("/dev/null", O_RDONLY), 0);
  ::dup2(output, 1);
  ::dup2(errors, 2);
  std::vector<char*> arguments;
  for (const std::string& argument : command) arguments.push_back(const_cast<char*>(argument.c_str()));
  arguments.push_back(nullptr);
  ::execv(arguments[0], arguments.data());
  ::_exit(127);
}

/// Reads available bytes; false at the end of the stream.
bool drain(int stream, std::string& into) {
  std::array<char, 65536> block;
  const ssize_t count = ::read(stream, block.data(), block.size());
  if (count <= 0) return false;
  if (into.size() < kMostKept) into.append(block.data(), static_cast<std::size_t>(count));
  return true;
}

ChildEnd runOnce(const std::vector<std::string>& command, double most) {
  int output[2];
  int errors[2];
  if (::pipe2(output, O_CLOEXEC) != 0 || ::pipe2(errors, O_CLOEXEC) != 0) throw std::runtime_error("no pipe");
  const auto begin = Clock::now();
  const pid_t child = ::fork();
  if (child < 0) throw std::runtime_error("no process");
  if (child == 0) execute(command, output[1], errors[1]);
  ::close(output[1]);
  ::close(errors[1]);
  ChildEnd end;
  std::array<pollfd, 2> streams{pollfd{output[0], POLLIN, 0}, pollfd{errors[0], POLLIN, 0}};
  const auto seconds = [&] { return std::chrono::duration<double>(Clock::now() - begin).count(); };
  while (streams[0].fd >= 0 || streams[1].fd >= 0) {
    if (seconds() > most) {
      end.hung = true;
      ::kill(-child, SIGKILL);
      break;
    }
    if (::poll(streams.data(), streams.size(), 100) <= 0) continue;
    if (streams[0].revents != 0 && !drain(output[0], end.output)) streams[0].fd = -1;
    if (streams[1].revents != 0 && !drain(errors[0], end.errors)) streams[1].fd = -1;
  }
  int status = 0;
  rusage usage{};
  ::wait4(child, &status, 0, &usage);
  ::close(output[0]);
  ::close(errors[0]);
  end.seconds = seconds();
  end.megabytes = usage.ru_maxrss / 1024;  // largest of the child and its collected children
  if (WIFEXITED(status)) end.exitCode = WEXITSTATUS(status);
  if (WIFSIGNALED(status)) end.signal = WTERMSIG(status);
  return end;
}

}  // namespace

ChildEnd runChild(const std::vector<std::string>& command, const ChildLimits& limits) {
  constexpr double kPatience = 10.0;
  ChildEnd end = runOnce(command, limits.seconds);
  if (end.hung) end = runOnce(command, kPatience * limits.seconds);
  return end;
}

}  // namespace glissade::oracle
