#include "engine/base/child_process.h"

#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <utility>

#include "engine/base/child_launch.h"
#include "engine/base/reserve_filled.h"

namespace glissade {
namespace {

using Clock = StopToken::Clock;

constexpr std::size_t kErrorBytes = 1U << 20U;
/// Longest wait for the end of a killed process. It ends at once, unless the kernel waits for a device.
constexpr auto kPatienceWithKernel = std::chrono::seconds(5);
constexpr auto kPollInterval = std::chrono::milliseconds(20);

/// Appends the available bytes of a pipe, up to a length of `most`, and drops the rest. True if bytes were dropped.
bool takeFrom(Descriptor& pipe, std::string& text, std::size_t most) {
  std::array<char, 65536> buffer{};
  bool dropped = false;
  // Reads at most one pipe's content per call, so that a child that writes for ever does not block the caller.
  for (int i = 0; i < 16 && pipe.valid(); ++i) {
    const ssize_t count = ::read(pipe.get(), buffer.data(), buffer.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0 && errno == EAGAIN) break;
    if (count <= 0) {
      pipe.close();
      break;
    }
    const std::size_t taken = std::min(static_cast<std::size_t>(count), most - text.size());
    text.append(buffer.data(), taken);
    dropped = dropped || taken < static_cast<std::size_t>(count);
  }
  return dropped;
}

double secondsOf(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

}  // namespace

std::vector<std::string> requiredEnvironment() {
  std::vector<std::string> environment;
  for (const std::string name : {"LD_LIBRARY_PATH", "ASAN_OPTIONS", "UBSAN_OPTIONS", "LSAN_OPTIONS", "TSAN_OPTIONS"}) {
    if (const char* value = std::getenv(name.c_str())) environment.push_back(name + "=" + value);
  }
  return environment;
}

Result<ChildProcess> ChildProcess::start(const ChildCommand& command) {
  auto launched = launchChild(command);
  if (!launched) return launched.error();
  ChildProcess child(std::move(*launched), command.limits);
  // Programs that read a file mostly write less than they read.
  reserveFilled(child.end_.output, std::min(command.limits.outputBytes, command.input.size()));
  return child;
}

ChildProcess::ChildProcess(LaunchedChild launched, const ChildLimits& limits)
    : pid_(launched.pid),
      process_(std::move(launched.process)),
      output_(std::move(launched.output)),
      errors_(std::move(launched.errors)),
      limits_(limits) {}

ChildProcess::ChildProcess(ChildProcess&& other) noexcept
    : pid_(std::exchange(other.pid_, 0)),
      process_(std::move(other.process_)),
      output_(std::move(other.output_)),
      errors_(std::move(other.errors_)),
      limits_(other.limits_),
      started_(other.started_),
      killed_(other.killed_),
      end_(std::move(other.end_)) {}

ChildProcess::~ChildProcess() {
  if (pid_ == 0) return;
  kill(ChildEnding::Stopped);
  output_.close();
  errors_.close();
  wait();
}

void ChildProcess::takeOutput() {
  if (takeFrom(output_, end_.output, limits_.outputBytes)) kill(ChildEnding::OutputTooLarge);
  takeFrom(errors_, end_.errors, kErrorBytes);
}

void ChildProcess::kill(ChildEnding ending) {
  if (killed_) return;
  killed_ = Clock::now();
  end_.ending = ending;
  ::kill(-pid_, SIGKILL);
}

bool ChildProcess::hasEnded() const {
  siginfo_t info{};
  return ::waitid(P_PID, static_cast<id_t>(pid_), &info, WEXITED | WNOHANG | WNOWAIT) != 0 || info.si_pid != 0;
}

bool ChildProcess::isGivenUp() const { return killed_ && Clock::now() - *killed_ > kPatienceWithKernel; }

std::optional<ChildEnd> ChildProcess::poll() {
  const std::chrono::duration<double> lived = Clock::now() - started_;
  // The end is checked first, because all that a child wrote before its end is then in the pipes.
  const bool ended = hasEnded() || isGivenUp();
  takeOutput();
  if (ended) return collect();
  if (limits_.seconds > 0.0 && lived.count() > limits_.seconds) kill(ChildEnding::TimeOver);
  return std::nullopt;
}

/// Precondition: the child has ended, or is given up.
ChildEnd ChildProcess::collect() {
  ::kill(-pid_, SIGKILL);  // kills processes that it left running; the group is ours until the child is collected
  int status = 0;
  rusage usage{};
  const bool collected = ::wait4(pid_, &status, WNOHANG, &usage) == pid_;
  pid_ = 0;
  const std::chrono::duration<double> lived = Clock::now() - started_;
  end_.wallSeconds = lived.count();
  if (!collected) return std::move(end_);
  if (WIFSIGNALED(status)) end_.signal = WTERMSIG(status);
  if (WIFEXITED(status)) end_.exitCode = WEXITSTATUS(status);
  if (!killed_ && end_.signal != 0) end_.ending = ChildEnding::Signalled;
  end_.cpuSeconds = secondsOf(usage.ru_utime) + secondsOf(usage.ru_stime);
  end_.peakMemoryMb = static_cast<double>(usage.ru_maxrss) / 1024.0;
  return std::move(end_);
}

ChildEnd ChildProcess::wait(const StopToken& stop) {
  while (true) {
    if (stop.stopRequested()) kill(ChildEnding::Stopped);
    if (auto end = poll()) return std::move(*end);
    std::array<pollfd, 3> sources{
        {{process_.get(), POLLIN, 0}, {output_.get(), POLLIN, 0}, {errors_.get(), POLLIN, 0}}};
    ::poll(sources.data(), sources.size(), static_cast<int>(kPollInterval.count()));
  }
}

Result<ChildEnd> runChild(const ChildCommand& command, const StopToken& stop) {
  auto child = ChildProcess::start(command);
  if (!child) return child.error();
  return child->wait(stop);
}

}  // namespace glissade
