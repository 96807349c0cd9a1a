#include "engine/base/thread_team.h"

#include <exception>
#include <utility>

#include "engine/base/cpu_time.h"

namespace glissade {

ThreadTeam::ThreadTeam(std::size_t helpers) {
  helpers_.reserve(helpers);
  try {
    while (helpers_.size() < helpers) {
      Helper& self = helpers_.emplace_back();
      self.thread = std::thread([this, &self] { help(self); });
    }
  } catch (const std::exception&) {  // no more threads, or no memory for one
    helpers_.pop_back();             // the existing threads do all the work
  }
}

ThreadTeam::~ThreadTeam() {
  {
    const std::lock_guard lock(mutex_);
    dismissed_ = true;
  }
  jobsArrived_.notify_all();
  for (Helper& helper : helpers_) helper.thread.join();
}

void ThreadTeam::run(std::size_t count, const Job& job) {
  std::unique_lock lock(mutex_);
  job_ = &job;
  count_ = count;
  next_ = 0;
  ended_ = 0;
  failure_ = nullptr;
  if (count > 1) jobsArrived_.notify_all();
  workOff(lock, nullptr);
  jobsEnded_.wait(lock, [this] { return ended_ == count_; });
  if (failure_) std::rethrow_exception(std::exchange(failure_, nullptr));
}

void ThreadTeam::help(Helper& self) {
  std::unique_lock lock(mutex_);
  for (;;) {
    jobsArrived_.wait(lock, [this] { return dismissed_ || next_ < count_; });
    if (dismissed_) return;
    workOff(lock, &self);
  }
}

/// Works on jobs until there are none; `self` is null on the calling thread.
void ThreadTeam::workOff(std::unique_lock<std::mutex>& lock, Helper* self) {
  while (next_ < count_) {
    const std::size_t mine = next_++;
    lock.unlock();
    std::exception_ptr failure;
    try {
      (*job_)(mine);
    } catch (...) {
      failure = std::current_exception();
    }
    const double cpuSeconds = self != nullptr ? threadCpuSeconds() : 0.0;
    lock.lock();
    if (failure && (!failure_ || mine < failedJob_)) {
      failure_ = failure;
      failedJob_ = mine;
    }
    if (self != nullptr) self->cpuSeconds = cpuSeconds;
    if (++ended_ == count_) jobsEnded_.notify_one();
  }
}

double ThreadTeam::helpersCpuSeconds() const {
  const std::lock_guard lock(mutex_);
  double sum = 0.0;
  for (const Helper& helper : helpers_) sum += helper.cpuSeconds;
  return sum;
}

}  // namespace glissade
