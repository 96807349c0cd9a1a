#pragma once

#include <cstdint>

#include "engine/geometry/wrench.h"
#include "engine/operator/operator_input.h"

namespace glissade {

/// What a haptic device last measured, world frame. Its driver maps workspace and view to the world.
struct HapticState {
  Pose X_WD;                  ///< where the hand holds the object
  Twist V_WD;                 ///< of X_WD
  std::uint32_t buttons = 0;  ///< a bit each, set while pressed
};

/// The strongest that a device renders, scaled like its workspace, so that force times velocity in the
/// world is the power at the hand whatever the object's size.
struct HapticLimits {
  double force;   ///< N
  double torque;  ///< N m
};

/// A device of six degrees of freedom that pushes back. Owned and called by one thread, a thousand times
/// a second: all functions return at once.
class HapticDevice {
 public:
  virtual ~HapticDevice() = default;

  /// The state now, dt seconds after the last call. A real device lives in its own time and leaves dt
  /// alone; a simulated one advances by it, under the wrench rendered last.
  virtual HapticState advance(double dt) = 0;
  /// The wrench on the hand until the next call, within the limits.
  virtual void render(const Wrench& wrench) = 0;
  virtual HapticLimits limits() const = 0;
  /// The object was put there: from now on the hand holds it there, at rest (a driver clutches anew).
  virtual void place(const Pose& X_WD) = 0;
  /// A new run: a scripted hand begins anew.
  virtual void restart() {}
  /// False while the device is away.
  virtual bool connected() const { return true; }
};

}  // namespace glissade
