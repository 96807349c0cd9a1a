#pragma once

#include <mutex>
#include <optional>
#include <utility>

#include "engine/base/diagnostic.h"

namespace glissade {

/// The last failure of a device's reader, written by the reader's thread and read by any.
class ReaderProblem {
 public:
  void set(std::optional<Diagnostic> problem) {
    const std::lock_guard lock(mutex_);
    problem_ = std::move(problem);
  }
  std::optional<Diagnostic> get() const {
    const std::lock_guard lock(mutex_);
    return problem_;
  }

 private:
  mutable std::mutex mutex_;
  std::optional<Diagnostic> problem_;
};

}  // namespace glissade
