#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "engine/operator/operator_input.h"

namespace glissade {

/// The six axes of a device as it reports them, each in [-1, 1]: translation x y z, rotation x y z.
using RawAxes = std::array<double, 6>;

/// A range of a shaping value: what sliders offer and files may hold.
struct ShapingRange {
  double lowest;
  double highest;
};
inline constexpr ShapingRange kDeadZoneRange{0.0, 0.5};
inline constexpr ShapingRange kGainRange{0.1, 3.0};
inline constexpr ShapingRange kExponentRange{1.0, 4.0};
inline constexpr ShapingRange kSpeedRange{0.1, 4.0};

/// How one axis of a device becomes one axis of motion.
struct AxisShaping {
  std::size_t source = 0;  ///< which raw axis drives it
  double deadZone = 0.05;  ///< share of the way that counts as rest
  double gain = 1.0;       ///< slope of the answer; full deflection is never exceeded
  double exponent = 1.0;   ///< of the response curve: 1 is straight, more is finer about the centre
  bool inverted = false;
};

/// The axes in which a deflection is meant.
enum class MotionFrame {
  View,   ///< right, up and towards the eye, on the screen
  World,  ///< as in the front view: right is x, up is z, towards you is -y
  Object  ///< the object's own x, y, z
};

/// Everything between a device and the motion it makes: one pipeline for 6D mouse, keys and gamepad.
struct DeviceShaping {
  DeviceShaping();  ///< every axis drives its own

  std::array<AxisShaping, 6> axes;
  bool dominantAxis = false;  ///< only the most deflected axis counts
  bool translationLocked = false;
  bool rotationLocked = false;
  MotionFrame frame = MotionFrame::View;
  double linearSpeed = 1.0;   ///< factor of the speed at full deflection
  double angularSpeed = 1.0;  ///< likewise
};
bool operator==(const AxisShaping& a, const AxisShaping& b);
bool operator==(const DeviceShaping& a, const DeviceShaping& b);

/// The same with every value in its range; what is no number becomes the default.
DeviceShaping inRange(DeviceShaping shaping);

/// The answer of an axis to a raw deflection: 0 inside the dead zone and continuous at its edge, odd,
/// monotone, in [-1, 1]. Raw values beyond [-1, 1] count as full; what is no number is rest.
double shapeAxis(const AxisShaping& axis, double raw);

/// Which axis dominates, from one moment to the next. An axis stays dominant until another is deflected
/// clearly more or until it comes to rest: two equal axes do not flicker, and none is stuck.
class DominantAxis {
 public:
  /// Only the dominant one of these axes; the others are 0.
  RawAxes filter(const RawAxes& shaped);
  void reset() { current_.reset(); }

 private:
  std::optional<std::size_t> current_;
};

/// Raw axes through the whole pipeline, but for frame and speed.
Deflection shape(const DeviceShaping& shaping, const RawAxes& raw, DominantAxis& dominant);

/// The view and speeds that a deflection is integrated with: those of the window, in the shaping's frame
/// and with its factors.
OperatorFrame shapedFrame(const DeviceShaping& shaping, const OperatorView& view);

}  // namespace glissade
