#pragma once

#include "engine/collision/contact_planes.h"
#include "engine/operator/haptic/surroundings.h"

namespace glissade {

/// The object as obstacles constrain it (god-object, Zilles and Salisbury 1995; in six degrees of freedom, Ortega et
/// al. 2007): it follows the device, stops at contact and slides along the tangent planes of its contacts. It moves in
/// balls that are proved free: from a configuration with clearance c, no motion of less than c metres of any point
/// meets an obstacle, however old the data are. So it never passes through an obstacle; late data only make it slower.
///
/// An object that was put into collision follows the device freely until it is out, as with all devices.
class GodObject {
 public:
  explicit GodObject(double objectRadius);

  /// Puts the object there; nothing is known about its surroundings yet.
  void place(const Pose& q);
  /// Takes the newest surroundings of a configuration that the object has passed since it was placed. Until
  /// surroundings of the place itself have come, others are ignored, because they are older than the placement.
  void learn(const Surroundings& surroundings);
  /// Moves towards X_WD as far as the motion is proved free. Stays while nothing is known.
  const Pose& follow(const Pose& X_WD);

  const Pose& pose() const { return q_; }
  /// True if more data would let it move farther, or it has moved since the last data.
  bool needsSurroundings() const { return !known_ || q_ != surroundings_.q; }
  /// The nearest obstacle in the latest data, moved along with the object; body -1: none within reach.
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
