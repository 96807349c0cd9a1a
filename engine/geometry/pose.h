#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace glissade {

using Vector3 = Eigen::Vector3d;
using Quaternion = Eigen::Quaterniond;
using Box3 = Eigen::AlignedBox3d;

/// A rigid transform X_AB: takes coordinates in frame B to coordinates in frame A (Drake's
/// notation). Metres; the quaternion is unit. A configuration q of the object is X_WB.
struct Pose {
  Vector3 position = Vector3::Zero();
  Quaternion orientation = Quaternion::Identity();

  static Pose identity() { return {}; }
  static Pose translation(const Vector3& p) { return {p, Quaternion::Identity()}; }
};

/// Exact equality of every coordinate (q and -q differ): for determinism tests.
bool operator==(const Pose& a, const Pose& b);
inline bool operator!=(const Pose& a, const Pose& b) { return !(a == b); }

/// p_A = X_AB * p_B. Inline, with the products of Eigen's quaternions in their order, because collision queries place
/// every triangle with it.
inline Vector3 operator*(const Pose& X_AB, const Vector3& p_B) {
  const Vector3 axis = X_AB.orientation.vec();
  const Vector3 twice = 2.0 * axis.cross(p_B);
  return p_B + X_AB.orientation.w() * twice + axis.cross(twice) + X_AB.position;
}
/// X_AC = X_AB * X_BC.
Pose operator*(const Pose& X_AB, const Pose& X_BC);
Pose inverse(const Pose& X_AB);
Eigen::Isometry3d toIsometry(const Pose& X_AB);
Pose fromIsometry(const Eigen::Isometry3d& X_AB);

/// Orientation by the URDF convention: fixed-axis roll, pitch, yaw in radians.
Quaternion fromRollPitchYaw(double roll, double pitch, double yaw);
/// Roll, pitch in [-pi/2, pi/2], and yaw of this orientation; where pitch is at a bound, roll is 0.
Vector3 rollPitchYawOf(const Quaternion& orientation);

/// True if all coordinates are finite and the quaternion's norm is within tolerance::kQuaternionNorm of one.
bool isValid(const Pose& pose);

/// Angle between two orientations, in [0, pi], radians.
double angleBetween(const Quaternion& a, const Quaternion& b);

/// The rotation vector (axis times angle, world frame) that takes a to b the short way.
Vector3 rotationVector(const Quaternion& a, const Quaternion& b);
Quaternion fromRotationVector(const Vector3& rotation);

/// The straight motion of the papers' planners: linear in position, shortest great arc in
/// orientation; t in [0, 1].
Pose interpolate(const Pose& a, const Pose& b, double t);

}  // namespace glissade
