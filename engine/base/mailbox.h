#pragma once

#include <functional>
#include <mutex>
#include <utility>

namespace glissade {

/// A value that threads exchange. The latest one counts. All functions may be called on any thread and return at once;
/// those whose names begin with `try` do not even wait for a thread that is reading or writing.
template <class Value>
class Mailbox {
 public:
  Mailbox() = default;
  explicit Mailbox(Value value) : value_(std::move(value)) {}

  Value get() const {
    const std::lock_guard lock(mutex_);
    return value_;
  }
  /// Takes the value and leaves an empty one.
  Value take() {
    const std::lock_guard lock(mutex_);
    return std::exchange(value_, Value{});
  }
  void set(Value value) {
    change([&](Value& kept) {
      kept = std::move(value);
      return true;
    });
  }
  /// Calls `change` with the value. It returns true if the listener is to be notified.
  template <class Change>
  void change(const Change& change) {
    {
      const std::lock_guard lock(mutex_);
      if (!change(value_)) return;
    }
    const std::lock_guard lock(listenerMutex_);
    if (listener_) listener_();
  }

  /// Sets the value without notifying the listener. False: another thread was using it, and it was not set.
  bool trySet(const Value& value) {
    const std::unique_lock lock(mutex_, std::try_to_lock);
    if (lock) value_ = value;
    return lock.owns_lock();
  }
  /// Takes the value; an empty value while another thread is using it.
  Value tryTake() {
    const std::unique_lock lock(mutex_, std::try_to_lock);
    return lock ? std::exchange(value_, Value{}) : Value{};
  }

  /// Sets a function that is called after a change, on the thread that made it. It must return at once. It may read the
  /// value and must not change it. After setListener({}) has returned no call is under way.
  void setListener(std::function<void()> listener) {
    const std::lock_guard lock(listenerMutex_);
    listener_ = std::move(listener);
  }

 private:
  mutable std::mutex mutex_;
  Value value_{};
  std::mutex listenerMutex_;
  std::function<void()> listener_;
};

}  // namespace glissade
