#pragma once

#include <algorithm>
#include <limits>

#include "engine/geometry/pose.h"

namespace glissade {

/// Whether doubles can tell this clearance (metres) along a straight motion of an object with this radius: the
/// rounding of the object's coordinates is small against it. False for coordinates that are not finite.
/// A certificate of a motion that is not resolved would be about the rounding.
inline bool resolvesClearance(const Pose& from, const Pose& to, double objectRadius, double clearance) {
  // A placed corner comes out of fewer than this many roundings of the largest coordinate.
  constexpr double kRoundings = 16.0;
  // They may come to this share of the clearance.
  constexpr double kShare = 0.05;
  const double farthest = std::max(from.position.cwiseAbs().maxCoeff(), to.position.cwiseAbs().maxCoeff());
  const double rounding = kRoundings * std::numeric_limits<double>::epsilon() * (farthest + objectRadius);
  return rounding <= kShare * clearance;
}

}  // namespace glissade
