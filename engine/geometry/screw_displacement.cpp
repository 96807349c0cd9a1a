#include "engine/geometry/screw_displacement.h"

#include <cmath>

namespace glissade {
namespace {

constexpr double kNoTurn = 1e-9;  ///< radians

}  // namespace

ScrewDisplacement::ScrewDisplacement(const Pose& from, const Pose& to)
    : from_(from), turn_(rotationVector(from.orientation, to.orientation)), advance_(to.position - from.position) {
  const double angle = turn_.norm();
  if (angle < kNoTurn) {
    turn_.setZero();
    return;
  }
  const Vector3 axis = turn_ / angle;
  const Vector3 moved = to.position - fromRotationVector(turn_) * from.position;
  advance_ = axis * axis.dot(moved);
  const Vector3 across = moved - advance_;
  point_ = 0.5 * (across + axis.cross(across) / std::tan(0.5 * angle));
}

Pose ScrewDisplacement::at(double share) const {
  const Quaternion turn = fromRotationVector(share * turn_);
  return {point_ + turn * (from_.position - point_) + share * advance_, (turn * from_.orientation).normalized()};
}

}  // namespace glissade
