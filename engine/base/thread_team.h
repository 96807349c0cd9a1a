#pragma once

#include <algorithm>
#include <condition_variable>
#include <cstddef>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace glissade {

/// Number of threads that the machine runs at once, at least 1.
inline std::size_t usableCores() { return std::max(1U, std::thread::hardware_concurrency()); }

/// Threads that help the calling one with independent jobs. Used by one thread at a time; the helpers sleep in between
/// and are joined in the destructor.
class ThreadTeam {
 public:
  /// Starts `helpers` threads, or fewer where the system provides no more.
  explicit ThreadTeam(std::size_t helpers);
  ~ThreadTeam();
  ThreadTeam(const ThreadTeam&) = delete;
  ThreadTeam& operator=(const ThreadTeam&) = delete;

  using Job = std::function<void(std::size_t)>;
  /// Calls job(0) ... job(count - 1), each once, some of them on the calling thread, and returns when all have ended.
  /// If jobs throw, the exception of the lowest number is thrown.
  void run(std::size_t count, const Job& job);

  /// Number of working threads, including the calling one.
  std::size_t threads() const { return helpers_.size() + 1; }
  /// Processor time of the helpers since they were made, seconds. Call it between calls of run().
  double helpersCpuSeconds() const;

 private:
  struct Helper {
    std::thread thread;
    double cpuSeconds = 0.0;
  };

  void help(Helper& self);
  void workOff(std::unique_lock<std::mutex>& lock, Helper* self);

  mutable std::mutex mutex_;  ///< guards everything but the threads themselves
  std::condition_variable jobsArrived_;
  std::condition_variable jobsEnded_;
  const Job* job_ = nullptr;
  std::size_t count_ = 0;
  std::size_t next_ = 0;   ///< first job that nobody has begun
  std::size_t ended_ = 0;  ///< number of ended jobs
  std::size_t failedJob_ = 0;
  std::exception_ptr failure_;  ///< exception of that job
  bool dismissed_ = false;
  std::vector<Helper> helpers_;  ///< not moved after their start
};

}  // namespace glissade
