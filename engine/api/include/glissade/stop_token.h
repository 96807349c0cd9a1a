#pragma once

#include <atomic>
#include <chrono>
#include <memory>
#include <optional>

namespace glissade {

/// Read side of a request to stop, cheap to copy and safe to read from any thread. Long loops check it in every step
/// (a stop answers within 50 ms).
class StopToken {
 public:
  using Clock = std::chrono::steady_clock;  ///< clock of deadlines

  /// A token that never stops.
  StopToken() = default;

  /// True once the source was asked to stop or the deadline has passed.
  bool stopRequested() const {
    if (flag_ && flag_->load(std::memory_order_relaxed)) return true;
    return deadline_ && Clock::now() >= *deadline_;
  }

  /// A token for this request with an additional deadline; the earlier deadline counts.
  StopToken withDeadline(Clock::time_point deadline) const {
    StopToken token = *this;
    if (!token.deadline_ || deadline < *token.deadline_) token.deadline_ = deadline;
    return token;
  }

 private:
  friend class StopSource;
  explicit StopToken(std::shared_ptr<const std::atomic<bool>> flag) : flag_(std::move(flag)) {}

  std::shared_ptr<const std::atomic<bool>> flag_;
  std::optional<Clock::time_point> deadline_;
};

/// Write side of a request to stop. Thread-safe, also in signal handlers.
class StopSource {
 public:
  StopToken token() const { return StopToken(flag_); }                   ///< read side
  void requestStop() { flag_->store(true, std::memory_order_relaxed); }  ///< asks all tokens to stop

 private:
  std::shared_ptr<std::atomic<bool>> flag_ = std::make_shared<std::atomic<bool>>(false);
};

}  // namespace glissade
