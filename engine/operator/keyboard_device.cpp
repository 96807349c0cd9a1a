#include "engine/operator/keyboard_device.h"

#include <algorithm>

namespace glissade {
namespace {

/// Seconds from rest to full deflection.
constexpr double kRampUp = 0.3;

double ramped(double actual, double wanted, double dt) {
  if (wanted == 0.0 || actual * wanted < 0.0) actual = 0.0;
  const double step = dt / kRampUp;
  return actual + std::clamp(wanted - actual, -step, step);
}

Vector3 ramped(const Vector3& actual, const Vector3& wanted, double dt) {
  return {ramped(actual.x(), wanted.x(), dt), ramped(actual.y(), wanted.y(), dt), ramped(actual.z(), wanted.z(), dt)};
}

}  // namespace

Pose KeyboardDevice::advance(double dt, const OperatorView& view, const Box3& bounds) {
  if (dt <= 0.0) return view.q_device;
  const Deflection wanted = keys_->get();
  actual_.translation = ramped(actual_.translation, wanted.translation, dt);
  actual_.rotation = ramped(actual_.rotation, wanted.rotation, dt);
  return integrate(view.q_device, toTwist(actual_, view.frame), bounds, dt);
}

}  // namespace glissade
