#pragma once

#include <condition_variable>
#include <map>
#include <mutex>
#include <optional>
#include <utility>

#include "engine/base/stop_token.h"

namespace glissade {

/// Values that are made once for each key, by the first thread that asks. Other threads that ask meanwhile wait for
/// that thread. Thread-safe.
template <class Key, class Value>
class MadeOnce {
 public:
  /// The value of the key. `make` is called outside of the lock. If it throws, or if a stop is requested when it
  /// returns, the value is not kept, and the next thread makes it anew.
  template <class Make>
  Value get(const Key& key, const StopToken& stop, const Make& make) {
    if (const std::optional<Value> known = knownOrReserved(key)) return *known;
    std::optional<Value> made;
    try {
      made = make();
    } catch (...) {
      put(key, std::nullopt);
      throw;
    }
    put(key, stop.stopRequested() ? std::nullopt : made);
    return *made;
  }

 private:
  /// Nothing: the calling thread makes the value.
  std::optional<Value> knownOrReserved(const Key& key) {
    std::unique_lock lock(mutex_);
    for (;;) {
      const auto [entry, isNew] = values_.try_emplace(key);
      if (isNew) return std::nullopt;
      if (entry->second) return entry->second;
      changed_.wait(lock);
    }
  }

  void put(const Key& key, std::optional<Value> value) {
    {
      const std::lock_guard lock(mutex_);
      if (value) {
        values_[key] = std::move(value);
      } else {
        values_.erase(key);
      }
    }
    changed_.notify_all();
  }

  std::mutex mutex_;
  std::condition_variable changed_;
  std::map<Key, std::optional<Value>> values_;  ///< nothing: a thread makes the value
};

}  // namespace glissade
