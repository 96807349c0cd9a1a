#include "engine/planning/contact/contact_sampler.h"

#include <cmath>
#include <numbers>

namespace glissade {
namespace {

/// A unit vector orthogonal to n: Gram-Schmidt on the axis with the smallest component of n.
Vector3 orthogonalTo(const Vector3& n) {
  Eigen::Index axis = 0;
  n.cwiseAbs().minCoeff(&axis);
  const Vector3 e = Vector3::Unit(axis);
  return (e - e.dot(n) * n).normalized();
}

}  // namespace

void ContactSampler::enter(const OperatorSample& operatorSample, double gap, double discRadius) {
  const Vector3 n = operatorSample.nearest.normal_W();
  origin_ = operatorSample.q_device;
  origin_.position -= n * (operatorSample.nearest.distance - gap);
  t1_ = orthogonalTo(n);
  t2_ = n.cross(t1_);
  discRadius_ = discRadius;
}

Pose ContactSampler::sample() {
  const double radius = discRadius_ * std::sqrt(stream_.uniform());
  const double angle = 2.0 * std::numbers::pi * stream_.uniform();
  Pose q = origin_;
  q.position += radius * (std::cos(angle) * t1_ + std::sin(angle) * t2_);
  return q;
}

}  // namespace glissade
