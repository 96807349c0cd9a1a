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

/// True if the memory of a child can be limited. Sanitizers reserve terabytes of address space, so that it is not
/// limited under them.
#ifdef GLISSADE_SANITIZED
inline constexpr bool kMemoryCanBeLimited = false;
#else
inline constexpr bool kMemoryCanBeLimited = true;
#endif

/// Limits of a child process.
struct ChildLimits {
  double seconds = 0.0;                  ///< wall-clock time after which it is killed; 0: no limit
  std::uint64_t cpuSeconds = 0;          ///< processor time (RLIMIT_CPU, ends by SIGXCPU); 0: no limit
  std::uint64_t memoryBytes = 0;         ///< address space (RLIMIT_AS); 0: no limit
  std::size_t outputBytes = 64U << 20U;  ///< bytes of standard output after which it is killed
};

/// A program to run. Its environment is `environment` only, and its open files are its standard streams only.
struct ChildCommand {
  std::string program;                   ///< path of the file
  std::vector<std::string> arguments;    ///< arguments without the program's name
  std::string_view input;                ///< standard input; copied at the start
  std::vector<std::string> environment;  ///< entries of the form "NAME=value"
  ChildLimits limits;
};

/// The variables of this process that a child of the project's own needs: the folders of shared libraries, and the
/// options of sanitizers.
std::vector<std::string> requiredEnvironment();

enum class ChildEnding {
  Exited,          ///< exited by itself, with an exit code
  Signalled,       ///< ended by a signal that this process did not send
  TimeOver,        ///< killed at the end of ChildLimits::seconds
  OutputTooLarge,  ///< killed above ChildLimits::outputBytes
  Stopped          ///< killed because the stop token asked for it
};

/// Result of a child process.
struct ChildEnd {
  ChildEnding ending = ChildEnding::Exited;
  int exitCode = 0;    ///< defined if it exited
  int signal = 0;      ///< signal that ended it; 0: none
  std::string output;  ///< standard output, at most ChildLimits::outputBytes
  std::string errors;  ///< standard error, at most 1 MiB
  double wallSeconds = 0.0;
  double cpuSeconds = 0.0;    ///< processor time in user and kernel mode, including its own children
  double peakMemoryMb = 0.0;  ///< largest resident set, megabytes
};

struct LaunchedChild;

/// A child process in a session of its own. It cannot outlive this object, nor the thread that started it
/// (PR_SET_PDEATHSIG). Its whole process group is killed at its end, at a limit and by the destructor.
///
/// Threads: start, poll and wait are called by one thread, which lives as long as this object. No function blocks for
/// ever: the wait for a child that the kernel cannot end is given up after 5 seconds.
class ChildProcess {
 public:
  /// Starts a program. Errors are Internal: the program or a limit that cannot be set, with the system's reason.
  static Result<ChildProcess> start(const ChildCommand& command);
  ~ChildProcess();
  ChildProcess(ChildProcess&& other) noexcept;
  ChildProcess& operator=(ChildProcess&&) = delete;

  pid_t pid() const { return pid_; }

  /// Reads the child's output and enforces the limits without waiting. Returns the result once the child has ended, and
  /// must not be called again after that.
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
  Descriptor output_;  ///< closed at its end of the stream
  Descriptor errors_;
  ChildLimits limits_;
  Clock::time_point started_ = Clock::now();
  std::optional<Clock::time_point> killed_;
  ChildEnd end_;
};

/// Runs a program to its end: ChildProcess::start and ChildProcess::wait.
Result<ChildEnd> runChild(const ChildCommand& command, const StopToken& stop = {});

}  // namespace glissade
