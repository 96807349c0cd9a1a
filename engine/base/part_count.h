#pragma once

#include <cstddef>
#include <mutex>
#include <utility>

#include "engine/base/work_watch.h"

namespace glissade {

/// Reports the finished share of a number of parts of work. Thread-safe.
class PartCount {
 public:
  PartCount(WorkWatch watch, std::size_t parts) : watch_(std::move(watch)), parts_(parts) {}

  void add() {
    const std::lock_guard lock(mutex_);
    watch_.report(static_cast<double>(++done_) / static_cast<double>(parts_));
  }

 private:
  WorkWatch watch_;
  std::size_t parts_;
  std::mutex mutex_;
  std::size_t done_ = 0;
};

}  // namespace glissade
