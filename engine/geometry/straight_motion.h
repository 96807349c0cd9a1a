#pragma once

#include "engine/geometry/pose.h"

namespace glissade {

/// `interpolate` between the same two poses for many t, bit by bit: what does not depend on t is computed once.
class StraightMotion {
 public:
  StraightMotion(const Pose& a, const Pose& b);

  Pose at(double t) const;

 private:
  Pose a_, b_;
  bool isShort_;  ///< the orientations differ by rounding at most
  double sign_;
  double angle_ = 0.0;  ///< between the quaternions
  double sine_ = 1.0;
};

}  // namespace glissade
