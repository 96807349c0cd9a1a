#pragma once

#include <mutex>
#include <optional>
#include <utility>

namespace glissade {

/// A value between two threads: the latest wins. The try-functions never wait: they do nothing, and say
/// so, while the other side is at it.
template <class T>
class Latest {
 public:
  void put(T value) {
    const std::lock_guard lock(mutex_);
    value_ = std::move(value);
  }
  std::optional<T> take() {
    const std::lock_guard lock(mutex_);
    return std::exchange(value_, std::nullopt);
  }
  bool tryPut(const T& value) {
    const std::unique_lock lock(mutex_, std::try_to_lock);
    if (lock) value_ = value;
    return lock.owns_lock();
  }
  std::optional<T> tryTake() {
    const std::unique_lock lock(mutex_, std::try_to_lock);
    return lock ? std::exchange(value_, std::nullopt) : std::nullopt;
  }

 private:
  std::mutex mutex_;
  std::optional<T> value_;
};

}  // namespace glissade
