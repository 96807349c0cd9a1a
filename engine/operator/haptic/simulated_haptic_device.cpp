#include "engine/operator/haptic/simulated_haptic_device.h"

#include <algorithm>

namespace glissade {
namespace {

// Values at the hand, of the size of common desktop devices. A torque acts at a lever of kHandRadius.
constexpr double kHandRadius = 0.05;  ///< metres of the hand's travel for one radius of the object
constexpr double kMass = 0.3;         ///< mass of device and hand, kg
constexpr double kDamping = 6.0;      ///< damping, N s/m
constexpr double kArm = 150.0;        ///< stiffness of the arm's spring, N/m
constexpr double kArmForce = 6.0;     ///< largest force of the arm, N
constexpr double kDeviceForce = 8.0;  ///< largest force of the device, N

Vector3 capped(const Vector3& v, double longest) {
  const double length = v.norm();
  return length > longest ? Vector3(v * (longest / length)) : v;
}

}  // namespace

HandMotion alongRoute(std::vector<Pose> route, const Se3Metric& metric, double speed) {
  return [route = std::move(route), metric, speed](double seconds, const Pose& begin) {
    Pose at = begin;
    double left = speed * seconds;
    for (const Pose& next : route) {
      const double length = metric.distance(at, next);
      if (length > left) return interpolate(at, next, left / length);
      left -= length;
      at = next;
    }
    return at;
  };
}

SimulatedHapticDevice::SimulatedHapticDevice(HandMotion motion, double objectRadius)
    : motion_(std::move(motion)), worldPerHand_(objectRadius / kHandRadius) {}

HapticLimits SimulatedHapticDevice::limits() const {
  return {kDeviceForce / worldPerHand_, kDeviceForce * kHandRadius};
}

void SimulatedHapticDevice::place(const Pose& X_WD) {
  state_.X_WD = X_WD;
  state_.V_WD = Twist();
  begin_ = X_WD;
  seconds_ = 0.0;
}

void SimulatedHapticDevice::restart() {
  begin_ = state_.X_WD;
  seconds_ = 0.0;
}

/// Advances by semi-implicit Euler, in the hand's own metres and newtons.
HapticState SimulatedHapticDevice::advance(double dt) {
  if (dt <= 0.0) return state_;
  seconds_ += dt;
  const Pose target = motion_(seconds_, begin_);
  Pose& X = state_.X_WD;
  const Vector3 pull = capped(kArm / worldPerHand_ * (target.position - X.position), kArmForce);
  const Vector3 turn = capped(kArm * kHandRadius * rotationVector(X.orientation, target.orientation), kArmForce);
  const Vector3 push = capped(wrench_.force_W * worldPerHand_, kDeviceForce);
  const Vector3 twist = capped(wrench_.torque_W / kHandRadius, kDeviceForce);
  const double decay = 1.0 / (1.0 + dt * kDamping / kMass);
  Vector3& v = state_.V_WD.linear_W;
  Vector3& w = state_.V_WD.angular_W;
  v = decay * (v + dt / kMass * worldPerHand_ * (pull + push));
  w = decay * (w + dt / (kMass * kHandRadius) * (turn + twist));
  X.position += dt * v;
  X.orientation = (fromRotationVector(dt * w) * X.orientation).normalized();
  return state_;
}

}  // namespace glissade
