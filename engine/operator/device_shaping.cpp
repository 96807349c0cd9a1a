#include "engine/operator/device_shaping.h"

#include <algorithm>
#include <cmath>

namespace glissade {
namespace {

/// Factor by which another axis must be deflected more to become dominant.
constexpr double kHysteresis = 1.25;

void bring(double& value, const ShapingRange& range, double otherwise) {
  value = std::isfinite(value) ? std::clamp(value, range.lowest, range.highest) : otherwise;
}

/// Front view: x right, z up, -y towards the eye.
Quaternion frontView() { return Quaternion(Eigen::AngleAxisd(std::acos(0.0), Vector3::UnitX())); }

}  // namespace

DeviceShaping::DeviceShaping() {
  for (std::size_t i = 0; i < axes.size(); ++i) axes[i].source = i;
}

bool operator==(const AxisShaping& a, const AxisShaping& b) {
  return a.source == b.source && a.deadZone == b.deadZone && a.gain == b.gain && a.exponent == b.exponent &&
         a.inverted == b.inverted;
}

bool operator==(const DeviceShaping& a, const DeviceShaping& b) {
  return a.axes == b.axes && a.dominantAxis == b.dominantAxis && a.translationLocked == b.translationLocked &&
         a.rotationLocked == b.rotationLocked && a.frame == b.frame && a.linearSpeed == b.linearSpeed &&
         a.angularSpeed == b.angularSpeed;
}

DeviceShaping inRange(DeviceShaping shaping) {
  const AxisShaping otherwise;
  for (std::size_t i = 0; i < shaping.axes.size(); ++i) {
    AxisShaping& axis = shaping.axes[i];
    if (axis.source >= shaping.axes.size()) axis.source = i;
    bring(axis.deadZone, kDeadZoneRange, otherwise.deadZone);
    bring(axis.gain, kGainRange, otherwise.gain);
    bring(axis.exponent, kExponentRange, otherwise.exponent);
  }
  bring(shaping.linearSpeed, kSpeedRange, 1.0);
  bring(shaping.angularSpeed, kSpeedRange, 1.0);
  return shaping;
}

double shapeAxis(const AxisShaping& axis, double raw) {
  const double way = std::min(std::abs(raw), 1.0);
  if (!(way > axis.deadZone)) return 0.0;
  const double share = (way - axis.deadZone) / (1.0 - axis.deadZone);
  const double answer = std::min(axis.gain * std::pow(share, axis.exponent), 1.0);
  return (raw < 0.0) != axis.inverted ? -answer : answer;
}

RawAxes DominantAxis::filter(const RawAxes& shaped) {
  std::size_t largest = 0;
  for (std::size_t i = 1; i < shaped.size(); ++i) {
    if (std::abs(shaped[i]) > std::abs(shaped[largest])) largest = i;
  }
  RawAxes only{};
  if (shaped[largest] == 0.0) {
    current_.reset();
    return only;
  }
  const double now = current_ ? std::abs(shaped[*current_]) : 0.0;
  if (now == 0.0 || std::abs(shaped[largest]) > kHysteresis * now) current_ = largest;
  only[*current_] = shaped[*current_];
  return only;
}

Deflection shape(const DeviceShaping& shaping, const RawAxes& raw, DominantAxis& dominant) {
  RawAxes shaped{};
  for (std::size_t i = 0; i < shaped.size(); ++i) {
    const bool locked = i < 3 ? shaping.translationLocked : shaping.rotationLocked;
    if (!locked) shaped[i] = shapeAxis(shaping.axes[i], raw[shaping.axes[i].source]);
  }
  if (shaping.dominantAxis) {
    shaped = dominant.filter(shaped);
  } else {
    dominant.reset();
  }
  return {{shaped[0], shaped[1], shaped[2]}, {shaped[3], shaped[4], shaped[5]}};
}

OperatorFrame shapedFrame(const DeviceShaping& shaping, const OperatorView& view) {
  OperatorFrame frame = view.frame;
  if (shaping.frame == MotionFrame::World) frame.R_WV = frontView();
  if (shaping.frame == MotionFrame::Object) frame.R_WV = view.q_device.orientation;
  frame.speed.linear *= shaping.linearSpeed;
  frame.speed.angular *= shaping.angularSpeed;
  return frame;
}

}  // namespace glissade
