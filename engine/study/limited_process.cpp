#include "engine/study/limited_process.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>

namespace glissade {
namespace {

constexpr rlim_t kMostOutput = 64U << 20;
constexpr int kCannotStart = 127;

/// Between fork and exec: only calls that are safe there (signal-safety(7)).
[[noreturn]] void becomeChild(const char* program, char* const* argv, pid_t parent, int output, int errors,
                              rlim_t memory) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) _exit(kCannotStart);
  setpgid(0, 0);
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
  const rlimit outputLimit{kMostOutput, kMostOutput};
  setrlimit(RLIMIT_FSIZE, &outputLimit);
  const rlimit noCore{0, 0};
  setrlimit(RLIMIT_CORE, &noCore);
  const rlimit memoryLimit{memory, memory};
  if (kMemoryCanBeLimited && memory > 0) setrlimit(RLIMIT_AS, &memoryLimit);
  const int nothing = open("/dev/null", O_RDONLY);
  dup2(nothing, STDIN_FILENO);
  dup2(output, STDOUT_FILENO);
  dup2(errors, STDERR_FILENO);
  execv(program, argv);
  _exit(kCannotStart);
}

std::string contentOf(int fd) {
  std::string content;
  std::array<char, 65536> buffer{};
  off_t at = 0;
  ssize_t count = 0;
  while ((count = pread(fd, buffer.data(), buffer.size(), at)) > 0) {
    content.append(buffer.data(), static_cast<std::size_t>(count));
    at += count;
  }
  return content;
}

double secondsOf(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

Diagnostic cannotStart(const std::string& program) {
  return {ErrorKind::Internal, program, "", std::string("cannot be started: ") + std::strerror(errno),
          "Run fewer jobs at once, or free some memory."};
}

}  // namespace

Result<std::unique_ptr<LimitedProcess>> LimitedProcess::start(const std::string& program,
                                                              const std::vector<std::string>& arguments,
                                                              const ProcessLimits& limits) {
  std::vector<char*> argv{const_cast<char*>(program.c_str())};
  for (const std::string& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
  argv.push_back(nullptr);
  const int output = memfd_create("output", MFD_CLOEXEC);
  const int errors = memfd_create("errors", MFD_CLOEXEC);
  const pid_t parent = getpid();
  const pid_t pid = output < 0 || errors < 0 ? -1 : fork();
  if (pid == 0) {
    becomeChild(program.c_str(), argv.data(), parent, output, errors, static_cast<rlim_t>(limits.memoryMb) << 20);
  }
  if (pid < 0) {
    const Diagnostic why = cannotStart(program);
    close(output);
    close(errors);
    return why;
  }
  return std::unique_ptr<LimitedProcess>(new LimitedProcess(pid, output, errors, limits.seconds));
}

LimitedProcess::LimitedProcess(pid_t pid, int output, int errors, double seconds)
    : pid_(pid), output_(output), errors_(errors), seconds_(seconds) {
  setpgid(pid, pid);  // also here: whoever comes first, so that the group is there when it is killed
}

LimitedProcess::~LimitedProcess() {
  if (pid_ > 0) {
    kill(-pid_, SIGKILL);
    while (waitpid(pid_, nullptr, 0) < 0 && errno == EINTR) {
    }
  }
  close(output_);
  close(errors_);
}

std::optional<ProcessEnd> LimitedProcess::poll() {
  const std::chrono::duration<double> lived = Clock::now() - started_;
  siginfo_t ended{};
  waitid(P_PID, static_cast<id_t>(pid_), &ended, WEXITED | WNOHANG | WNOWAIT);
  if (ended.si_pid == 0) {
    if (seconds_ > 0.0 && lived.count() > seconds_ && !killed_) {
      killed_ = true;
      kill(-pid_, SIGKILL);
    }
    return std::nullopt;
  }
  kill(-pid_, SIGKILL);  // what it may have left running; its group is ours until it is collected
  int status = 0;
  rusage usage{};
  wait4(pid_, &status, 0, &usage);
  pid_ = 0;
  ProcessEnd end;
  end.output = contentOf(output_);
  end.errors = contentOf(errors_);
  end.killed = killed_;
  if (WIFSIGNALED(status)) end.signal = WTERMSIG(status);
  if (WIFEXITED(status)) end.exitCode = WEXITSTATUS(status);
  end.wallSeconds = lived.count();
  end.cpuSeconds = secondsOf(usage.ru_utime) + secondsOf(usage.ru_stime);
  end.peakMemoryMb = static_cast<double>(usage.ru_maxrss) / 1024.0;
  return end;
}

}  // namespace glissade
