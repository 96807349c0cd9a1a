#pragma once

#include <condition_variable>
#include <cstddef>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace glissade {

/// Threads that help the calling one with pieces of work that do not depend on each other. Used by one
/// thread at a time; the helpers sleep in between and are joined in the destructor.
class ThreadTeam {
 public:
  /// With so many helpers, or fewer where the system gives no more threads.
  explicit ThreadTeam(std::size_t helpers);
  ~ThreadTeam();
  ThreadTeam(const ThreadTeam&) = delete;
  ThreadTeam& operator=(const ThreadTeam&) = delete;

  using Job = std::function<void(std::size_t)>;
  /// Calls job(0) ... job(count - 1), each once, some of them on the calling thread, and returns when all
  /// have ended. Of the exceptions that left them it throws the first by number.
  void run(std::size_t count, const Job& job);

  /// Threads at work, the calling one included.
  std::size_t threads() const { return helpers_.size() + 1; }
  /// What the helpers have had of the processor since they were made, between calls of run().
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
  std::size_t next_ = 0;   ///< the first job nobody has begun
  std::size_t ended_ = 0;  ///< jobs
  std::size_t failedJob_ = 0;
  std::exception_ptr failure_;  ///< of that job
  bool dismissed_ = false;
  std::vector<Helper> helpers_;  ///< never moved once they run
};

}  // namespace glissade
