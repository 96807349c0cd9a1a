#include "engine/import/child_process.h"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>

extern char** environ;

namespace glissade {
namespace {

using Clock = StopToken::Clock;

Diagnostic cannotStart(const std::string& program, int error) {
  return {ErrorKind::Internal, program, "", std::string("cannot be started: ") + std::strerror(error),
          "Reinstall the program: this part of it is missing."};
}

/// Reads until the end, a stop or the size; true at the end.
bool collect(int fd, const StopToken& stop, std::size_t most, std::string& output) {
  constexpr int kLookMilliseconds = 20;
  std::array<char, 65536> buffer{};
  while (output.size() <= most && !stop.stopRequested()) {
    pollfd descriptor{fd, POLLIN, 0};
    if (poll(&descriptor, 1, kLookMilliseconds) <= 0) continue;
    const ssize_t count = ::read(fd, buffer.data(), buffer.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return count == 0;
    output.append(buffer.data(), static_cast<std::size_t>(count));
  }
  return false;
}

}  // namespace

Result<ChildResult> runChild(const std::string& program, const std::vector<std::string>& arguments,
                             const std::string& inputFile, std::chrono::milliseconds patience, std::size_t mostOutput,
                             const StopToken& stop) {
  std::array<int, 2> pipe{};
  if (::pipe2(pipe.data(), O_CLOEXEC) != 0) return cannotStart(program, errno);

  std::vector<char*> argv{const_cast<char*>(program.c_str())};
  for (const std::string& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
  argv.push_back(nullptr);

  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, inputFile.c_str(), O_RDONLY | O_NONBLOCK, 0);
  posix_spawn_file_actions_adddup2(&actions, pipe[1], STDOUT_FILENO);
  posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
  pid_t pid = 0;
  const int error = posix_spawn(&pid, program.c_str(), &actions, nullptr, argv.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  ::close(pipe[1]);
  if (error != 0) {
    ::close(pipe[0]);
    return cannotStart(program, error);
  }

  ChildResult result;
  result.timedOut = !collect(pipe[0], stop.withDeadline(Clock::now() + patience), mostOutput, result.output);
  ::close(pipe[0]);
  if (result.timedOut) ::kill(pid, SIGKILL);
  int status = 0;
  while (::waitpid(pid, &status, 0) < 0 && errno == EINTR) {
  }
  if (WIFSIGNALED(status)) result.signal = WTERMSIG(status);
  if (WIFEXITED(status)) result.exitCode = WEXITSTATUS(status);
  return result;
}

}  // namespace glissade
