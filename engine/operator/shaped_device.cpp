#include "engine/operator/shaped_device.h"

#include <algorithm>

namespace glissade {
namespace {

/// Time from rest to full deflection of a key, seconds.
constexpr double kRampUp = 0.3;

double ramp(double actual, double target, double dt) {
  if (target == 0.0 || actual * target < 0.0) actual = 0.0;
  const double step = dt / kRampUp;
  return actual + std::clamp(target - actual, -step, step);
}

}  // namespace

Deflection HandShaper::deflection(double dt, const DeviceShaping& shaping, bool maySteer) {
  RawAxes raw = maySteer ? input_.mailbox.reading().axes : RawAxes{};
  if (input_.kind == InputKind::Keyboard) {
    for (std::size_t i = 0; i < raw.size(); ++i) ramped_[i] = ramp(ramped_[i], raw[i], dt);
    raw = ramped_;
  }
  return shape(shaping, raw, dominant_);
}

void HandShaper::restart() {
  ramped_ = RawAxes{};
  dominant_.reset();
}

ShapedDevice::ShapedDevice(HandInputsPtr hand, const HandInput& input)
    : hand_(std::move(hand)), input_(input), shaper_(input) {}

Pose ShapedDevice::advance(double dt, const OperatorView& view, const Box3& bounds) {
  if (dt <= 0.0) return view.q_device;
  const bool maySteer = hand_->target == SteeringTarget::Object && hand_->focused;
  const DeviceShaping shaping = input_.shaping.get();
  const Deflection deflection = shaper_.deflection(dt, shaping, maySteer);
  return integrate(view.q_device, toTwist(deflection, shapedFrame(shaping, view)), bounds, dt);
}

}  // namespace glissade
