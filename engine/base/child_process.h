#pragma once

#include <sys/types.h>

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/base/descriptor.h"
#include "engine/base/result.h"
#include "engine/base/stop_token.h"

namespace glissade {

/// Sanitizers reserve terabytes of address space: the memory of a child is not limited under them.
#ifdef GLISSADE_SANITIZED
inline constexpr bool kMemoryCanBeLimited = false;
#else
inline constexpr bool kMemoryCanBeLimited = true;
#endif

/// What a child process may use.
struct ChildLimits {
  double seconds = 0.0;                  ///< wall-clock time of its whole life, then it is killed; 0: no limit
  std::uint64_t cpuSeconds = 0;          ///< processor time (RLIMIT_CPU, ends by SIGXCPU); 0: no limit
  std::uint64_t memoryBytes = 0;         ///< address space (RLIMIT_AS); 0: no limit
  std::size_t outputBytes = 64U << 20U;  ///< of standard output, then it is killed
};

/// A program to run. It gets no environment but `environment`, and no open file but its standard streams.
struct ChildCommand {
  std::string program;                   ///< path of the file
  std::vector<std::string> arguments;    ///< without the program's name
  std::string_view input;                ///< its standard input; copied when it is started
  std::vector<std::string> environment;  ///< "NAME=value"
  ChildLimits limits;
};

/// The variables of this process that a child of the project's own needs: where shared libraries are,
/// and the options of sanitizers.
std::vector<std::string> requiredEnvironment();

enum class ChildEnding {
  Exited,          ///< by itself, with an exit code
  Signalled,       ///< by a signal that this process did not send
  TimeOver,        ///< killed at the end of ChildLimits::seconds
  OutputTooLarge,  ///< killed above ChildLimits::outputBytes
  Stopped          ///< killed because the stop token asked for it
};

/// What is known of a child process after its end.
struct ChildEnd {
  ChildEnding ending = ChildEnding::Exited;
  int exitCode = 0;    ///< meaningful where it exited
  int signal = 0;      ///< that ended it; 0: none
  std::string output;  ///< standard output, at most ChildLimits::outputBytes
  std::string errors;  ///< standard error; what exceeds 1 MiB is dropped
  double wallSeconds = 0.0;
  double cpuSeconds = 0.0;    ///< in user and kernel mode, with its own children
  double peakMemoryMb = 0.0;  ///< largest resident set
};

struct LaunchedChild;

/// A child process in a session of its own. It cannot outlive this object, nor the thread that started
/// it (PR_SET_PDEATHSIG). Its whole process group is killed at its end, at a limit and by the destructor.
///
/// Threads: start, poll and wait are called by one thread, which lives as long as this object.
/// No function blocks for ever: a child that the kernel cannot end is given up after 5 seconds.
class ChildProcess {
 public:
  /// Errors are Internal: the program or a limit that cannot be set, with the system's reason.
  static Result<ChildProcess> start(const ChildCommand& command);
  ~ChildProcess();
  ChildProcess(ChildProcess&& other) noexcept;
  ChildProcess& operator=(ChildProcess&&) = delete;

  pid_t pid() const { return pid_; }

  /// Takes over what the child has written and enforces the limits; does not wait. Gives the end once
  /// the child has ended, and must not be called again after that.
  std::optional<ChildEnd> poll();

  /// Waits for the end, the limits or the stop token, whichever is first.
  ChildEnd wait(const StopToken& stop = {});

 private:
  using Clock = StopToken::Clock;

  ChildProcess(LaunchedChild launched, const ChildLimits& limits);

  void takeOutput();
  void kill(ChildEnding ending);
  bool hasEnded() const;
  bool isGivenUp() const;
  ChildEnd collect();

  pid_t pid_ = 0;  ///< 0: ended and collected
  Descriptor process_;
  Descriptor output_;  ///< closed at its end
  Descriptor errors_;
  ChildLimits limits_;
  Clock::time_point started_ = Clock::now();
  std::optional<Clock::time_point> killed_;
  ChildEnd end_;
};

/// Runs a program to its end: ChildProcess::start and ChildProcess::wait.
Result<ChildEnd> runChild(const ChildCommand& command, const StopToken& stop = {});

}  // namespace glissade
