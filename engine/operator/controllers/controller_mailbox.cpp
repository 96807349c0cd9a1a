#include "engine/operator/controllers/controller_mailbox.h"

#include <algorithm>
#include <utility>

namespace glissade {
namespace {

std::optional<Pose> validOnly(const std::optional<Pose>& pose) { return pose && isValid(*pose) ? pose : std::nullopt; }

/// What is no number is 0.
double share(double value) { return value > 0.0 ? std::min(value, 1.0) : 0.0; }

}  // namespace

void ControllerMailbox::set(const ControllerReading& reading) {
  {
    const std::lock_guard lock(mutex_);
    reading_ = {validOnly(reading.X_WG), validOnly(reading.X_WA), share(reading.squeeze), reading.scale, reading.held};
    heard_ = Clock::now();
  }
  const std::lock_guard lock(listenerMutex_);
  if (listener_) listener_();
}

ControllerReading ControllerMailbox::reading() const {
  const std::lock_guard lock(mutex_);
  ControllerReading now = reading_;
  if (!silence_ || Clock::now() - heard_ <= *silence_) return now;
  now.X_WG = now.X_WA = std::nullopt;
  now.held = 0;
  return now;
}

void ControllerMailbox::setFeedback(const ControllerFeedback& feedback) {
  const std::lock_guard lock(mutex_);
  feedback_ = {feedback.holds, share(feedback.push), feedback.pointsAt};
}

ControllerFeedback ControllerMailbox::feedback() const {
  const std::lock_guard lock(mutex_);
  return feedback_;
}

void ControllerMailbox::setListener(std::function<void()> listener) {
  const std::lock_guard lock(listenerMutex_);
  listener_ = std::move(listener);
}

}  // namespace glissade
