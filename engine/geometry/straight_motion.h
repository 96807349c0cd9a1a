#pragma once

#include "engine/geometry/pose.h"

namespace glissade {

/// `interpolate` between the same two poses for many t, with bitwise equal results. The parts that do not depend on t
/// are computed once.
class StraightMotion {
 public:
  StraightMotion(const Pose& a, const Pose& b);

  Pose at(double t) const;

 private:
  Pose a_, b_;
  bool isShort_;  ///< the orientations differ by at most rounding
  double sign_;
  double angle_ = 0.0;  ///< angle between the quaternions
  double sine_ = 1.0;
};

}  // namespace glissade
