#pragma once

#include <cstdint>

#include "engine/geometry/wrench.h"
#include "engine/operator/operator_input.h"

namespace glissade {

/// The latest measurement of a haptic device, world frame. Its driver maps workspace and view to the world.
struct HapticState {
  Pose X_WD;                  ///< pose in which the hand holds the object
  Twist V_WD;                 ///< velocity of X_WD
  std::uint32_t buttons = 0;  ///< one bit for each button, set while pressed
};

/// Maximum force and torque of a device, scaled like its workspace, so that force times velocity in the world is the
/// power at the hand for any size of the object.
struct HapticLimits {
  double force;   ///< newtons
  double torque;  ///< newton metres
};

/// A device of six degrees of freedom that renders forces. Owned and called by one thread, a thousand times a second:
/// all functions return at once.
class HapticDevice {
 public:
  virtual ~HapticDevice() = default;

  /// The state dt seconds after the last call. A real device uses its own time and ignores dt; a simulated one advances
  /// by it, under the wrench rendered last.
  virtual HapticState advance(double dt) = 0;
  /// Renders a wrench on the hand until the next call, within the limits.
  virtual void render(const Wrench& wrench) = 0;
  virtual HapticLimits limits() const = 0;
  /// Tells the device that the object was put there: from now on the hand holds it there, at rest (a driver clutches
  /// anew).
  virtual void place(const Pose& X_WD) = 0;
  /// Begins a new run, in which a scripted hand starts again.
  virtual void restart() {}
  /// False while the device is disconnected.
  virtual bool connected() const { return true; }
};

}  // namespace glissade
