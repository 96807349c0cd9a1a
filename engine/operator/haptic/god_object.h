#pragma once

#include "engine/collision/contact_planes.h"
#include "engine/operator/haptic/surroundings.h"

namespace glissade {

/// The object as the obstacles let it be (god-object, Zilles and Salisbury 1995; in six degrees of
/// freedom, Ortega et al. 2007): follows the device, stops at contact and slides along the tangent
/// planes of what it touches. It moves in balls that are proved free: at a configuration with clearance
/// c no motion of fewer than c metres of any point meets an obstacle, however old that knowledge is. So
/// it never goes through anything; late knowledge makes it slower.
///
/// An object that was put into collision follows the device freely until it is out, as with all devices.
class GodObject {
 public:
  explicit GodObject(double objectRadius);

  /// Puts it there; nothing is known there yet.
  void place(const Pose& q);
  /// The newest knowledge, of a configuration that the object has come through since it was placed (until
  /// one about the place itself has come, others are left out: they are from before).
  void learn(const Surroundings& surroundings);
  /// Goes towards X_WD as far as it is proved free. Stays while nothing is known.
  const Pose& follow(const Pose& X_WD);

  const Pose& pose() const { return q_; }
  /// More knowledge would let it go farther, or it has moved since.
  bool curious() const { return !known_ || q_ != surroundings_.q; }
  /// The nearest obstacle as far as known, moved along with the object; body -1: none within reach.
  NearestObstacle nearest() const;

 private:
  SmallMotion stepTo(const Pose& X_WD) const;

  double radius_;
  Pose q_;
  bool known_ = false;
  Surroundings surroundings_;
  ContactPlanes contacts_;
};

}  // namespace glissade
