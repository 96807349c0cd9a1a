#pragma once

#include <numbers>

#include "engine/geometry/pose.h"

namespace glissade {

/// Screw motions about a fixed axis: a right-handed turn together with an advance by the pitch.
struct ScrewAxis {
  Vector3 point_W = Vector3::Zero();  ///< point on the axis
  Vector3 axis_W = Vector3::UnitZ();  ///< unit axis
  double pitch = 0.0;                 ///< advance along the axis for a full turn, metres; not 0; below 0: left-handed

  /// Angle of the turn in radians for an advance along the axis in metres.
  double turnFor(double advance) const { return advance / pitch * 2.0 * std::numbers::pi; }
};

/// Pose of a body after the screw motion with this advance along the axis, metres.
inline Pose screwed(const ScrewAxis& screw, const Pose& from, double advance) {
  const Quaternion turn(Eigen::AngleAxisd(screw.turnFor(advance), screw.axis_W));
  const Vector3 arm = from.position - screw.point_W;
  return {screw.point_W + turn * arm + advance * screw.axis_W, (turn * from.orientation).normalized()};
}

}  // namespace glissade
