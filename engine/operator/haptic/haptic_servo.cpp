#include "engine/operator/haptic/haptic_servo.h"

#include "engine/base/guarded.h"

namespace glissade {
namespace {

/// Energy that the field of repulsion may hold at the start: the largest force times this share of the object's radius.
constexpr double kStoredShare = 1.0 / 3.0;

PassivityController freshBalance(double objectRadius, const HapticLimits& limits) {
  return {objectRadius, limits, kStoredShare * limits.force * objectRadius};
}

Wrench inNewtons(const Wrench& shares, const HapticLimits& limits) {
  return {limits.force * shares.force_W, limits.torque * shares.torque_W};
}

Wrench inShares(const Wrench& wrench, const HapticLimits& limits) {
  return {wrench.force_W / limits.force, wrench.torque_W / limits.torque};
}

Pose apartness(const Pose& X_WD, const Pose& X_WB) {
  return {X_WB.position - X_WD.position, X_WB.orientation * X_WD.orientation.conjugate()};
}

}  // namespace

HapticServo::HapticServo(std::unique_ptr<HapticDevice> device, double objectRadius)
    : device_(std::move(device)),
      limits_(device_->limits()),
      object_(objectRadius),
      coupling_{objectRadius},
      passivity_(freshBalance(objectRadius, limits_)) {}

void HapticServo::place(const Pose& q) {
  device_->place(q);
  device_->render({});
  object_.place(q);
  X_WD_ = q;
  apart_ = Pose::identity();
  environment_ = Wrench();
  passivity_ = freshBalance(coupling_.objectRadius, limits_);
}

void HapticServo::stop() noexcept {
  // If the device refuses this, too, its driver must stop the force by itself.
  (void)guarded(GLISSADE_TEXT("stopping the haptic device"), [this] { device_->render({}); });
}

Wrench HapticServo::environmentWrench(const Guidance& guidance, const Pose& X_WD, double dt) {
  const Pose apart = apartness(X_WD, object_.pose());
  const Twist V_apart{(apart.position - apart_.position) / dt,
                      rotationVector(apart_.orientation, apart.orientation) / dt};
  apart_ = apart;
  const Wrench repelled = repulsion(guidance, object_.pose(), object_.nearest(), coupling_.objectRadius);
  return inNewtons(coupling_(X_WD, object_.pose(), V_apart) + repelled, limits_);
}

HapticCycle HapticServo::cycle(double dt, const Guidance& guidance, const Box3& bounds) {
  const HapticState hand = device_->advance(dt);
  passivity_.observe(X_WD_, hand.X_WD, environment_);
  X_WD_ = hand.X_WD;
  Pose target = hand.X_WD;
  target.position = target.position.cwiseMax(bounds.min()).cwiseMin(bounds.max());
  object_.follow(target);
  environment_ = passivity_.damped(environmentWrench(guidance, hand.X_WD, dt), hand.V_WD, dt);
  const Wrench felt = inShares(environment_, limits_);
  const Wrench drawn = attraction(guidance, object_.pose(), coupling_.objectRadius);
  // Attraction takes the rest of the range: the forces of obstacles and damping are always rendered.
  const Wrench total = saturated({felt.force_W + (1.0 - felt.force_W.norm()) * drawn.force_W,
                                  felt.torque_W + (1.0 - felt.torque_W.norm()) * drawn.torque_W});
  device_->render(inNewtons(total, limits_));
  return {object_.pose(), total, passivity_.balance()};
}

}  // namespace glissade
