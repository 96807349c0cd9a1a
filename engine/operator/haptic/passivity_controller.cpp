#include "engine/operator/haptic/passivity_controller.h"

#include <algorithm>

#include "engine/operator/guidance.h"

namespace glissade {
namespace {

/// The damper stays below this: its force at a tenth of a radius a second is the device's strongest. More
/// would shake a hand of 0.3 kg at 1 kHz.
constexpr double kRadiiPerSecondAtLimit = 0.1;

}  // namespace

Wrench withinLimits(const Wrench& wrench, const HapticLimits& limits) {
  const Wrench shares = saturated({wrench.force_W / limits.force, wrench.torque_W / limits.torque});
  return {limits.force * shares.force_W, limits.torque * shares.torque_W};
}

PassivityController::PassivityController(double objectRadius, const HapticLimits& limits, double stored)
    : radius_(objectRadius), limits_(limits), balance_(stored) {}

void PassivityController::observe(const Pose& last, const Pose& now, const Wrench& rendered) {
  balance_ -= rendered.force_W.dot(now.position - last.position) +
              rendered.torque_W.dot(rotationVector(last.orientation, now.orientation));
}

Wrench PassivityController::damped(const Wrench& wrench, const Twist& V_WD, double dt) const {
  const Wrench limited = withinLimits(wrench, limits_);
  const double speed = V_WD.linear_W.squaredNorm() + radius_ * radius_ * V_WD.angular_W.squaredNorm();
  if (balance_ >= 0.0 || speed <= 0.0) return limited;
  const double most = limits_.force / (kRadiiPerSecondAtLimit * radius_);
  const double damping = std::min(most, -balance_ / (dt * speed));
  const Wrench damper{-damping * V_WD.linear_W, -damping * radius_ * radius_ * V_WD.angular_W};
  return withinLimits(limited + damper, limits_);
}

}  // namespace glissade
