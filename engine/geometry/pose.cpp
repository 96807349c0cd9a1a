#include "engine/geometry/pose.h"

#include <algorithm>
#include <cmath>

#include "engine/base/tolerances.h"

namespace glissade {

bool operator==(const Pose& a, const Pose& b) {
  return a.position == b.position && a.orientation.coeffs() == b.orientation.coeffs();
}

Pose operator*(const Pose& X_AB, const Pose& X_BC) {
  return {X_AB * X_BC.position, (X_AB.orientation * X_BC.orientation).normalized()};
}

Pose inverse(const Pose& X_AB) {
  const Quaternion inverted = X_AB.orientation.conjugate();
  return {inverted * (-X_AB.position), inverted};
}

Eigen::Isometry3d toIsometry(const Pose& X_AB) {
  Eigen::Isometry3d transform = Eigen::Isometry3d::Identity();
  transform.linear() = X_AB.orientation.toRotationMatrix();
  transform.translation() = X_AB.position;
  return transform;
}

Pose fromIsometry(const Eigen::Isometry3d& X_AB) {
  return {X_AB.translation(), Quaternion(X_AB.linear()).normalized()};
}

Quaternion fromRollPitchYaw(double roll, double pitch, double yaw) {
  return Quaternion(Eigen::AngleAxisd(yaw, Vector3::UnitZ()) * Eigen::AngleAxisd(pitch, Vector3::UnitY()) *
                    Eigen::AngleAxisd(roll, Vector3::UnitX()))
      .normalized();
}

Vector3 rollPitchYawOf(const Quaternion& orientation) {
  constexpr double kUpright = 1e-12;  // least cosine of pitch; below it, roll and yaw turn about the same axis
  const Eigen::Matrix3d R = orientation.toRotationMatrix();
  const double cosine = std::hypot(R(0, 0), R(1, 0));
  const double pitch = std::atan2(-R(2, 0), cosine);
  if (cosine < kUpright) return {0.0, pitch, std::atan2(-R(0, 1), R(1, 1))};
  return {std::atan2(R(2, 1), R(2, 2)), pitch, std::atan2(R(1, 0), R(0, 0))};
}

bool isValid(const Pose& pose) {
  return pose.position.allFinite() && pose.orientation.coeffs().allFinite() &&
         std::abs(pose.orientation.norm() - 1.0) <= tolerance::kQuaternionNorm;
}

double angleBetween(const Quaternion& a, const Quaternion& b) {
  // atan2 of the relative rotation gives exactly zero for equal orientations; acos would lose half of the digits.
  const Quaternion relative = a.conjugate() * b;
  return 2.0 * std::atan2(relative.vec().norm(), std::abs(relative.w()));
}

Vector3 rotationVector(const Quaternion& a, const Quaternion& b) {
  Quaternion difference = b * a.conjugate();
  if (difference.w() < 0.0) difference.coeffs() *= -1.0;
  const double sine = difference.vec().norm();
  if (sine < 1e-12) return Vector3::Zero();
  return difference.vec() * (2.0 * std::atan2(sine, difference.w()) / sine);
}

Quaternion fromRotationVector(const Vector3& rotation) {
  const double angle = rotation.norm();
  if (angle < 1e-12) return Quaternion::Identity();
  return Quaternion(Eigen::AngleAxisd(angle, rotation / angle));
}

Pose interpolate(const Pose& a, const Pose& b, double t) {
  if (t <= 0.0) return a;
  if (t >= 1.0) return b;
  return {a.position + t * (b.position - a.position), a.orientation.slerp(t, b.orientation).normalized()};
}

}  // namespace glissade
