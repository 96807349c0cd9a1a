#pragma once

#include <memory>

#include "engine/operator/guidance.h"
#include "engine/operator/haptic/god_object.h"
#include "engine/operator/haptic/haptic_device.h"
#include "engine/operator/haptic/passivity_controller.h"

namespace glissade {

/// Spring and damper between device and object (virtual coupling: Colgate, Stanley and Brown 1995). All is
/// in shares of the device's limits and radii of the object, so that it is as stiff for a watch as for
/// a ship.
struct VirtualCoupling {
  double objectRadius = 1.0;     ///< metres
  double stiffness = 5.0;        ///< full force at a fifth of the radius (of a radian) apart
  double dampingSeconds = 2e-3;  ///< damping over stiffness; the device's own damping must outweigh it

  /// What pulls the device at X_WD to the object at X_WB; apart they go at V_apart (of object against
  /// device). Not saturated.
  Wrench operator()(const Pose& X_WD, const Pose& X_WB, const Twist& V_apart) const {
    const Vector3 apart = X_WB.position - X_WD.position + dampingSeconds * V_apart.linear_W;
    const Vector3 turned = rotationVector(X_WD.orientation, X_WB.orientation) + dampingSeconds * V_apart.angular_W;
    return {stiffness / objectRadius * apart, stiffness * turned};
  }
};

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
