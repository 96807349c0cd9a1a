#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "engine/base/enum_names.h"
#include "engine/operator/operator_input.h"

namespace glissade {

/// The six axes of a device as it reports them, each in [-1, 1]: translation x y z, rotation x y z.
using RawAxes = std::array<double, 6>;

/// Range of a shaping value in sliders and files.
struct ShapingRange {
  double lowest;
  double highest;
};
inline constexpr ShapingRange kDeadZoneRange{0.0, 0.5};
inline constexpr ShapingRange kGainRange{0.1, 3.0};
inline constexpr ShapingRange kExponentRange{1.0, 4.0};
inline constexpr ShapingRange kSpeedRange{0.1, 4.0};

/// Mapping of one axis of a device to one axis of motion.
struct AxisShaping {
  std::size_t source = 0;  ///< index of the raw axis that drives it
  double deadZone = 0.05;  ///< share of the range that counts as rest
  double gain = 1.0;       ///< slope of the response; full deflection is never exceeded
  double exponent = 1.0;   ///< exponent of the response curve: 1 is linear, more is finer about the centre
  bool inverted = false;
};

/// The axes to which a deflection refers.
enum class MotionFrame {
  View,   ///< right, up and towards the eye, on the screen
  World,  ///< as in the front view: right is x, up is z, towards you is -y
  Object  ///< the object's own x, y, z
};
inline constexpr EnumNames<MotionFrame, 3> kMotionFrameNames{{"view", "world", "object"}};

/// The mapping from a device to its motion: one pipeline for 6D mouse, keys and gamepad.
struct DeviceShaping {
  DeviceShaping();  ///< Every axis drives its own.

  std::array<AxisShaping, 6> axes;
  bool dominantAxis = false;  ///< only the most deflected axis counts
  bool translationLocked = false;
  bool rotationLocked = false;
  MotionFrame frame = MotionFrame::View;
  double linearSpeed = 1.0;   ///< factor of the speed at full deflection
  double angularSpeed = 1.0;  ///< factor of the angular speed at full deflection
};
bool operator==(const AxisShaping& a, const AxisShaping& b);
bool operator==(const DeviceShaping& a, const DeviceShaping& b);

/// The shaping with every value clamped to its range; a value that is no number becomes the default.
DeviceShaping inRange(DeviceShaping shaping);

/// The response of an axis to a raw deflection: 0 inside the dead zone and continuous at its edge, odd, monotone, in
/// [-1, 1]. Raw values beyond [-1, 1] are clamped; a value that is no number is rest.
double shapeAxis(const AxisShaping& axis, double raw);

/// Determines the dominant axis over time. An axis stays dominant until another is deflected clearly more or until it
/// comes to rest, so that two equal axes do not alternate and none is stuck.
class DominantAxis {
 public:
  /// Keeps only the dominant one of these axes; the others become 0.
  RawAxes filter(const RawAxes& shaped);
  void reset() { current_.reset(); }

 private:
  std::optional<std::size_t> current_;
};

/// Applies the whole pipeline to raw axes, except frame and speed.
Deflection shape(const DeviceShaping& shaping, const RawAxes& raw, DominantAxis& dominant);

/// The view and speeds for integrating a deflection: those of the window, in the shaping's frame and with its factors.
OperatorFrame shapedFrame(const DeviceShaping& shaping, const OperatorView& view);

}  // namespace glissade
