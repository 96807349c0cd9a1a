#pragma once

#include <memory>

#include "engine/operator/guidance.h"
#include "engine/operator/haptic/god_object.h"
#include "engine/operator/haptic/haptic_device.h"
#include "engine/operator/haptic/passivity_controller.h"
#include "engine/operator/haptic/virtual_coupling.h"

namespace glissade {

/// What comes out of a cycle.
struct HapticCycle {
  Pose q;              ///< of the object: free of collision
  Wrench wrench;       ///< as rendered, in shares of the limits (see Guidance)
  double balance = 0;  ///< of energy, J
};

/// One cycle of the haptic loop, without thread or clock: read the device, move the object after it as far
/// as is known to be free, add up coupling, repulsion and attraction, render what passivity allows. Takes
/// a few microseconds and asks no collision query: knowledge comes through learn(), early or late.
///
/// The observer watches coupling and repulsion. Attraction is there to do work on the hand: it is capped
/// and left out of the balance.
class HapticServo {
 public:
  static constexpr double kPeriod = 1e-3;  ///< s

  HapticServo(std::unique_ptr<HapticDevice> device, double objectRadius);

  /// The object is put there, with the hand; the balance of energy begins anew.
  void place(const Pose& q);
  void restart() { device_->restart(); }
  bool connected() const { return device_->connected(); }
  void learn(const Surroundings& surroundings) { object_.learn(surroundings); }
  const GodObject& object() const { return object_; }

  /// Renders no wrench from now on; to be called after an exception, which may be the device's.
  void stop() noexcept;

  HapticCycle cycle(double dt, const Guidance& guidance, const Box3& bounds);

 private:
  Wrench environmentWrench(const Guidance& guidance, const Pose& X_WD, double dt);

  std::unique_ptr<HapticDevice> device_;
  HapticLimits limits_;
  GodObject object_;
  VirtualCoupling coupling_;
  PassivityController passivity_;
  Pose X_WD_;           ///< of the last cycle
  Pose apart_;          ///< of the last cycle: position and turn of the object as the device sees them
  Wrench environment_;  ///< rendered in the last cycle, without attraction
};

}  // namespace glissade
