#pragma once

#include <vector>

#include "engine/geometry/pose.h"

namespace glissade {

/// A piece of a straight motion, so short that a point of the world moves nearly straight as the body sees it.
struct MotionPiece {
  Pose from;              ///< X_WB at its beginning
  Pose to;                ///< X_WB at its end
  double rotation = 0.0;  ///< radians
  double way = 0.0;       ///< of the body's origin, metres

  /// How far a point of the world, seen from the body, is from the straight line between where it is at the beginning
  /// and at the end, at most. `distance`: of the point from the body's origin, at most, at both ends; metres.
  ///
  /// With p_B(t) = R(t)^T (p - x(t)), rotation θ and way w the second derivative is at most θ² |p - x| + 2 θ w, and a
  /// curve is off its chord by at most an eighth of that.
  double deviation(double distance) const { return (rotation * distance + 2.0 * way) * rotation / 8.0; }
};

/// The straight motions between consecutive poses in pieces that deviate by at most `deviation` for points at
/// `distance` from the body's origin, and in which such a point moves by at most `longest` as the body sees it. Metres.
/// A path of one pose is a piece without motion.
std::vector<MotionPiece> piecesOf(const std::vector<Pose>& path, double distance, double deviation, double longest);

}  // namespace glissade
