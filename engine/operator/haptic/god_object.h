#pragma once

#include <vector>

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
  /// A tangent plane of an obstacle and the point of the object that touches it.
  struct Contact {
    Pose learntAt;
    Vector3 p_WPo;
    Vector3 normal_W;
    Vector3 p_BPn;
  };
  /// A small motion: metres, and radians times the object's radius.
  struct Step {
    Vector3 translation;
    Vector3 rotation;
  };

  double reach(const Pose& a, const Pose& b) const;
  double gap(const Contact& contact) const;
  void forgetFarContacts();
  Step stepTo(const Pose& X_WD) const;
  Step alongContacts(const Step& requested) const;
  Pose moved(const Step& step) const;

  double radius_;
  Pose q_;
  bool known_ = false;
  Surroundings surroundings_;
  std::vector<Contact> contacts_;
};

}  // namespace glissade
