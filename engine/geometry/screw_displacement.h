#pragma once

#include "engine/geometry/pose.h"

namespace glissade {

/// The screw motion that takes one pose to another: the shorter turn about an axis, and an advance along it. It is a
/// straight motion where both have the same orientation.
class ScrewDisplacement {
 public:
  ScrewDisplacement(const Pose& from, const Pose& to);

  /// The pose at a share of the motion: 0 is `from`, 1 is `to`; numbers above 1 continue the motion.
  Pose at(double share) const;

 private:
  Pose from_;
  Vector3 turn_;                     ///< axis times angle
  Vector3 point_ = Vector3::Zero();  ///< point on the axis
  Vector3 advance_;
};

}  // namespace glissade
