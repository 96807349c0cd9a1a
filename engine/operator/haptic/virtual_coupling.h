#pragma once

#include "engine/operator/haptic/haptic_device.h"

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

}  // namespace glissade
