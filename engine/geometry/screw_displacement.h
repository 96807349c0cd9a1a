#pragma once

#include "engine/geometry/pose.h"

namespace glissade {

/// The screw motion that takes one pose to another: a turn about an axis, the short way, and an advance along it. It is
/// a straight motion where both have the same orientation.
class ScrewDisplacement {
 public:
  ScrewDisplacement(const Pose& from, const Pose& to);

  /// 0 is `from`, 1 is `to`; numbers above 1 continue the motion.
  Pose at(double share) const;

 private:
  Pose from_;
  Vector3 turn_;                     ///< axis times angle
  Vector3 point_ = Vector3::Zero();  ///< on the axis
  Vector3 advance_;
};

}  // namespace glissade
