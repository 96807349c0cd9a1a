#pragma once

#include <mutex>
#include <utility>

namespace glissade {

/// A value between two threads: the latest wins. All functions may be called on any thread and return at once.
template <class Value>
class Latest {
 public:
  void set(Value value) {
    const std::lock_guard lock(mutex_);
    value_ = std::move(value);
  }
  Value get() const {
    const std::lock_guard lock(mutex_);
    return value_;
  }

 private:
  mutable std::mutex mutex_;
  Value value_{};
};

}  // namespace glissade
