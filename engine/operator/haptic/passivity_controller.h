#pragma once

#include "engine/operator/haptic/haptic_device.h"

namespace glissade {

/// Passivity observer and controller (Hannaford and Ryu 2002), impedance causality, in six degrees of
/// freedom: adds up the energy that the hand has put in, and when more has come out, damps the device
/// until the balance is restored.
class PassivityController {
 public:
  /// `stored`: energy in the fields at the start (J), which may come out without having been put in.
  PassivityController(double objectRadius, const HapticLimits& limits, double stored);

  /// The device went from `last` to `now` under the wrench that was returned last (kept by the caller).
  void observe(const Pose& last, const Pose& now, const Wrench& rendered);
  /// Energy put in so far, less what came out (J); below 0 only by what one cycle's damping could not take.
  double balance() const { return balance_; }
  /// The wrench with what damping the balance asks for, within the device's limits.
  Wrench damped(const Wrench& wrench, const Twist& V_WD, double dt) const;

 private:
  double radius_;
  HapticLimits limits_;
  double balance_;
};

/// Both parts within the limits, directions kept.
Wrench withinLimits(const Wrench& wrench, const HapticLimits& limits);

}  // namespace glissade
