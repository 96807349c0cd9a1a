#pragma once

#include <algorithm>
#include <limits>

#include "engine/geometry/pose.h"

namespace glissade {

/// True if the rounding of the object's coordinates is small against this clearance (metres) along a straight motion of
/// an object with this radius. False for coordinates that are not finite. A certificate of a motion without this
/// resolution would be invalid.
inline bool resolvesClearance(const Pose& from, const Pose& to, double objectRadius, double clearance) {
  // The position of a corner is the result of fewer than this many roundings of the largest coordinate.
  constexpr double kRoundings = 16.0;
  // Largest share of the clearance that the roundings may have.
  constexpr double kShare = 0.05;
  const double farthest = std::max(from.position.cwiseAbs().maxCoeff(), to.position.cwiseAbs().maxCoeff());
  const double rounding = kRoundings * std::numeric_limits<double>::epsilon() * (farthest + objectRadius);
  return rounding <= kShare * clearance;
}

}  // namespace glissade
