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

  /// The wrench that pulls the device at X_WD to the object at X_WB. V_apart is the velocity of the object relative to
  /// the device. The wrench is not limited.
  Wrench operator()(const Pose& X_WD, const Pose& X_WB, const Twist& V_apart) const {
    const Vector3 apart = X_WB.position - X_WD.position + dampingSeconds * V_apart.linear_W;
    const Vector3 turned = rotationVector(X_WD.orientation, X_WB.orientation) + dampingSeconds * V_apart.angular_W;
    return {stiffness / objectRadius * apart, stiffness * turned};
  }
};

/// Result of a cycle.
struct HapticCycle {
  Pose q;              ///< pose of the object, free of collision
  Wrench wrench;       ///< rendered wrench, in shares of the limits (see Guidance)
  double balance = 0;  ///< balance of energy, joules
};

/// One cycle of the haptic loop, without thread or clock: it reads the device, moves the object after it as far as the
/// motion is known to be free, adds coupling, repulsion and attraction, and renders the wrench that passivity allows.
/// It takes a few microseconds and makes no collision query. Surroundings come through learn(), early or late.
///
/// The observer monitors coupling and repulsion. Attraction is meant to do work on the hand: it is capped and not in
/// the balance.
class HapticServo {
 public:
  static constexpr double kPeriod = 1e-3;  ///< seconds

  HapticServo(std::unique_ptr<HapticDevice> device, double objectRadius);

  /// Puts the object and the hand there; the balance of energy begins anew.
  void place(const Pose& q);
  void restart() { device_->restart(); }
  bool connected() const { return device_->connected(); }
  void learn(const Surroundings& surroundings) { object_.learn(surroundings); }
  const GodObject& object() const { return object_; }

  /// Renders no wrench from now on. For use after an exception, which may come from the device.
  void stop() noexcept;

  HapticCycle cycle(double dt, const Guidance& guidance, const Box3& bounds);

 private:
  Wrench environmentWrench(const Guidance& guidance, const Pose& X_WD, double dt);

  std::unique_ptr<HapticDevice> device_;
  HapticLimits limits_;
  GodObject object_;
  VirtualCoupling coupling_;
  PassivityController passivity_;
  Pose X_WD_;           ///< device pose of the last cycle
  Pose apart_;          ///< offset of the object from the device in the last cycle: position and turn
  Wrench environment_;  ///< wrench rendered in the last cycle, without attraction
};

}  // namespace glissade
