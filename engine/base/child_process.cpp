#include "engine/base/child_process.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <sys/wait.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <utility>

#include "engine/base/reserve_filled.h"

namespace glissade {

/// A program that has just been started.
struct LaunchedChild {
  pid_t pid = 0;
  Descriptor process;  ///< pidfd: readable at its end
  Descriptor output;   ///< read end of its standard output, non-blocking
  Descriptor errors;   ///< read end of its standard error, non-blocking
};

namespace {

constexpr int kCannotStart = 127;

/// The steps of a start, for the message about the one that failed.
enum class Step { Streams, Fork, Session, Limits, Descriptors, Load };

struct Failure {
  Step step;
  int error;
};

CatalogueText nameOf(Step step) {
  switch (step) {
    case Step::Streams: return GLISSADE_TEXT("its input and output cannot be made");
    case Step::Fork: return GLISSADE_TEXT("no process can be made");
    case Step::Session: return GLISSADE_TEXT("it cannot have a session of its own");
    case Step::Limits: return GLISSADE_TEXT("its limits cannot be set");
    case Step::Descriptors: return GLISSADE_TEXT("its open files cannot be closed");
    case Step::Load: break;
  }
  return GLISSADE_TEXT("its file cannot be run");
}

Diagnostic cannotStart(const std::string& program, const Failure& failure) {
  const bool missing = failure.step == Step::Load && failure.error != ENOMEM && failure.error != EAGAIN;
  return {missing ? ErrorKind::MalformedInput : ErrorKind::LimitReached,
          program,
          "",
          {GLISSADE_TEXT("cannot be started: %1: %2"), {nameOf(failure.step), std::strerror(failure.error)}},
          missing ? GLISSADE_TEXT("Install the program again.")
                  : GLISSADE_TEXT("Run fewer programs at once, or free some memory.")};
}

/// A descriptor above the standard streams, so that none is overwritten when these are set.
Descriptor aboveStandardStreams(int fd) {
  const Descriptor given(fd);
  return Descriptor(given.valid() ? ::fcntl(given.get(), F_DUPFD_CLOEXEC, STDERR_FILENO + 1) : -1);
}

struct Pipe {
  Descriptor read;
  Descriptor write;

  bool valid() const { return read.valid() && write.valid(); }
};

Pipe makePipe(int flagsOfReader) {
  std::array<int, 2> ends{-1, -1};
  if (::pipe2(ends.data(), O_CLOEXEC) != 0) return {};
  Pipe pipe{aboveStandardStreams(ends[0]), aboveStandardStreams(ends[1])};
  if (pipe.valid()) ::fcntl(pipe.read.get(), F_SETFL, flagsOfReader);
  return pipe;
}

/// The bytes in memory that nobody can change any more; invalid where there is no memory for them.
Descriptor makeInput(std::string_view bytes) {
  Descriptor input = aboveStandardStreams(::memfd_create("input", MFD_CLOEXEC | MFD_ALLOW_SEALING));
  while (input.valid() && !bytes.empty()) {
    const ssize_t count = ::write(input.get(), bytes.data(), bytes.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return {};
    bytes.remove_prefix(static_cast<std::size_t>(count));
  }
  constexpr int kSeals = F_SEAL_WRITE | F_SEAL_GROW | F_SEAL_SHRINK | F_SEAL_SEAL;
  const bool sealed =
      input.valid() && ::lseek(input.get(), 0, SEEK_SET) == 0 && ::fcntl(input.get(), F_ADD_SEALS, kSeals) == 0;
  return sealed ? std::move(input) : Descriptor();
}

/// Pointers to texts that outlive it, and a null at the end, as execve wants them.
std::vector<char*> pointersTo(const std::vector<std::string>& texts) {
  std::vector<char*> pointers;
  pointers.reserve(texts.size() + 1);
  for (const std::string& text : texts) pointers.push_back(const_cast<char*>(text.c_str()));
  pointers.push_back(nullptr);
  return pointers;
}

struct Limit {
  __rlimit_resource resource;
  rlimit value;
};

std::vector<Limit> limitsOf(const ChildLimits& limits) {
  std::vector<Limit> list{{RLIMIT_CORE, {0, 0}}};
  // SIGXCPU at the first number says why the child ended; SIGKILL at the second cannot be ignored.
  if (limits.cpuSeconds > 0) list.push_back({RLIMIT_CPU, {limits.cpuSeconds, limits.cpuSeconds + 1}});
  const bool memory = kMemoryCanBeLimited && limits.memoryBytes > 0;
  if (memory) list.push_back({RLIMIT_AS, {limits.memoryBytes, limits.memoryBytes}});
  return list;
}

/// Everything that the child needs between fork and exec, where it can allocate nothing.
struct Plan {
  const char* program;
  char* const* arguments;
  char* const* environment;
  const std::vector<Limit>& limits;
  pid_t parent;
  int input;
  int output;
  int errors;
  int status;  ///< where a Failure is written; closed by exec
};

[[noreturn]] void giveUp(const Plan& plan, Step step) {
  const Failure failure{step, errno};
  [[maybe_unused]] const ssize_t written = ::write(plan.status, &failure, sizeof failure);
  ::_exit(kCannotStart);
}

/// Between fork and exec: only calls that are safe there (signal-safety(7)).
[[noreturn]] void becomeProgram(const Plan& plan) {
  if (::setsid() < 0 || ::prctl(PR_SET_PDEATHSIG, SIGKILL) != 0) giveUp(plan, Step::Session);
  if (::getppid() != plan.parent) ::_exit(kCannotStart);
  for (int signal = 1; signal < NSIG; ++signal) ::signal(signal, SIG_DFL);
  sigset_t none;
  ::sigemptyset(&none);
  ::sigprocmask(SIG_SETMASK, &none, nullptr);
  for (const Limit& limit : plan.limits) {
    if (::setrlimit(limit.resource, &limit.value) != 0) giveUp(plan, Step::Limits);
  }
  const bool standard = ::dup2(plan.input, STDIN_FILENO) >= 0 && ::dup2(plan.output, STDOUT_FILENO) >= 0 &&
                        ::dup2(plan.errors, STDERR_FILENO) >= 0;
  if (!standard || ::close_range(STDERR_FILENO + 1, ~0U, CLOSE_RANGE_CLOEXEC) != 0) giveUp(plan, Step::Descriptors);
  ::execve(plan.program, plan.arguments, plan.environment);
  giveUp(plan, Step::Load);
}

/// Forks with all signals blocked: no handler of this process may run in the child.
pid_t forkInto(const Plan& plan) {
  sigset_t all;
  sigset_t before;
  ::sigfillset(&all);
  ::pthread_sigmask(SIG_SETMASK, &all, &before);
  const pid_t pid = ::fork();
  if (pid == 0) becomeProgram(plan);
  const int error = errno;
  ::pthread_sigmask(SIG_SETMASK, &before, nullptr);
  errno = error;
  return pid;
}

/// Waits until the program is loaded, which closes the pipe, or until the child says what failed.
std::optional<Failure> failureFrom(const Descriptor& status) {
  Failure failure{};
  ssize_t count = 0;
  while ((count = ::read(status.get(), &failure, sizeof failure)) < 0 && errno == EINTR) {
  }
  return count == sizeof failure ? std::optional(failure) : std::nullopt;
}

/// Starts a program in a session of its own with the limits of the command. Returns after the program
/// was loaded (execve). Errors are Internal and name the step that failed.
Result<LaunchedChild> launchChild(const ChildCommand& command) {
  const Descriptor input = makeInput(command.input);
  Pipe output = makePipe(O_NONBLOCK);
  Pipe errors = makePipe(O_NONBLOCK);
  Pipe status = makePipe(0);
  if (!input.valid() || !output.valid() || !errors.valid() || !status.valid()) {
    return cannotStart(command.program, {Step::Streams, errno});
  }
  std::vector<char*> arguments = pointersTo(command.arguments);
  arguments.insert(arguments.begin(), const_cast<char*>(command.program.c_str()));
  const std::vector<char*> environment = pointersTo(command.environment);
  const std::vector<Limit> limits = limitsOf(command.limits);
  const pid_t pid = forkInto({command.program.c_str(), arguments.data(), environment.data(), limits, ::getpid(),
                              input.get(), output.write.get(), errors.write.get(), status.write.get()});
  if (pid < 0) return cannotStart(command.program, {Step::Fork, errno});
  status.write.close();
  const std::optional<Failure> failure = failureFrom(status.read);
  Descriptor process(failure ? -1 : static_cast<int>(::syscall(SYS_pidfd_open, pid, 0)));
  if (process.valid()) return LaunchedChild{pid, std::move(process), std::move(output.read), std::move(errors.read)};
  const Diagnostic why = cannotStart(command.program, failure.value_or(Failure{Step::Fork, errno}));
  ::kill(pid, SIGKILL);
  ::waitpid(pid, nullptr, 0);
  return why;
}

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
