#include "engine/operator/controllers/controller_mailbox.h"

#include <algorithm>

namespace glissade {
namespace {

std::optional<Pose> validOnly(const std::optional<Pose>& pose) { return pose && isValid(*pose) ? pose : std::nullopt; }

/// The value clamped to [0, 1]; 0 for a value that is no number.
double share(double value) { return value > 0.0 ? std::min(value, 1.0) : 0.0; }

}  // namespace

void ControllerMailbox::set(const ControllerReading& reading) {
  heard_.set({{validOnly(reading.X_WG), validOnly(reading.X_WA), share(reading.squeeze), reading.scale, reading.held},
              Clock::now()});
}

ControllerReading ControllerMailbox::reading() const {
  auto [now, at] = heard_.get();
  if (!silence_ || Clock::now() - at <= *silence_) return now;
  now.X_WG = now.X_WA = std::nullopt;
  now.held = 0;
  return now;
}

void ControllerMailbox::setFeedback(const ControllerFeedback& feedback) {
  feedback_.set({feedback.holds, share(feedback.push), feedback.pointsAt});
}

}  // namespace glissade
