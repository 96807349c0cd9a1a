#include "engine/geometry/straight_motion.h"

#include <cmath>
#include <limits>

namespace glissade {

StraightMotion::StraightMotion(const Pose& a, const Pose& b) : a_(a), b_(b) {
  const double cosine = a.orientation.dot(b.orientation);
  sign_ = cosine < 0.0 ? -1.0 : 1.0;
  isShort_ = std::abs(cosine) >= 1.0 - std::numeric_limits<double>::epsilon();
  if (isShort_) return;
  angle_ = std::acos(std::abs(cosine));
  sine_ = std::sin(angle_);
}

/// Evaluates the products of Eigen's slerp in their order.
Pose StraightMotion::at(double t) const {
  if (t <= 0.0) return a_;
  if (t >= 1.0) return b_;
  const double ofA = isShort_ ? 1.0 - t : std::sin((1.0 - t) * angle_) / sine_;
  const double ofB = sign_ * (isShort_ ? t : std::sin(t * angle_) / sine_);
  const Quaternion between(ofA * a_.orientation.coeffs() + ofB * b_.orientation.coeffs());
  return {a_.position + t * (b_.position - a_.position), between.normalized()};
}

}  // namespace glissade
