#pragma once

#include <numbers>

#include "engine/geometry/pose.h"

namespace glissade {

/// Screw motions about a fixed axis: a turn by the right hand together with an advance by the pitch.
struct ScrewAxis {
  Vector3 point_W = Vector3::Zero();  ///< on the axis
  Vector3 axis_W = Vector3::UnitZ();  ///< unit
  double pitch = 0.0;                 ///< metres along the axis for a full turn; not 0; below 0: left-handed

  /// Radians of the turn for an advance along the axis, metres.
  double turnFor(double advance) const { return advance / pitch * 2.0 * std::numbers::pi; }
};

/// Where the screw motion has a body after it has advanced along the axis from there, metres.
inline Pose screwed(const ScrewAxis& screw, const Pose& from, double advance) {
  const Quaternion turn(Eigen::AngleAxisd(screw.turnFor(advance), screw.axis_W));
  const Vector3 arm = from.position - screw.point_W;
  return {screw.point_W + turn * arm + advance * screw.axis_W, (turn * from.orientation).normalized()};
}

}  // namespace glissade
