#pragma once

#include <sys/types.h>

#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/base/result.h"
#include "engine/study/run_result.h"

namespace glissade {

/// Sanitizers reserve terabytes of address space for themselves: no limit of memory under them.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
inline constexpr bool kMemoryCanBeLimited = false;
#else
inline constexpr bool kMemoryCanBeLimited = true;
#endif

struct ProcessLimits {
  double seconds = 0.0;        ///< of wall-clock time, then it is killed; 0 is no limit
  std::uint64_t memoryMb = 0;  ///< of address space (RLIMIT_AS); 0 is no limit
};

/// A child process in a group of its own that cannot outlive us: it dies with this object, and with
/// the thread that started it, however that ends. It reads nothing; what it says goes to memory.
class LimitedProcess {
 public:
  static Result<std::unique_ptr<LimitedProcess>> start(const std::string& program,
                                                       const std::vector<std::string>& arguments,
                                                       const ProcessLimits& limits);
  ~LimitedProcess();
  LimitedProcess(const LimitedProcess&) = delete;
  LimitedProcess& operator=(const LimitedProcess&) = delete;

  /// Does not wait: nothing while it runs. Kills it once it is over its time. Once it has given an
  /// end it must not be asked again.
  std::optional<ProcessEnd> poll();

 private:
  using Clock = std::chrono::steady_clock;

  LimitedProcess(pid_t pid, int output, int errors, double seconds);

  pid_t pid_;  ///< 0: ended and collected
  int output_;
  int errors_;
  double seconds_;
  bool killed_ = false;
  Clock::time_point started_ = Clock::now();
};

}  // namespace glissade
