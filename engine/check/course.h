#pragma once

#include <algorithm>
#include <cmath>

#include "engine/geometry/triangle_mesh.h"

namespace glissade::check {

/// A straight motion: a line, and a rotation vector in the object's frame.
class Course {
 public:
  Course(const Pose& from, const Pose& to) : from_(from), way_(to.position - from.position) {
    Quaternion turn = from.orientation.conjugate() * to.orientation;
    if (turn.w() < 0.0) turn.coeffs() = -turn.coeffs();
    const double sine = turn.vec().norm();
    angle_ = 2.0 * std::atan2(sine, turn.w());
    if (sine > 0.0) axis_ = turn.vec() / sine;
  }

  Eigen::Isometry3d at(double t) const {
    Eigen::Isometry3d place = Eigen::Isometry3d::Identity();
    place.linear() = from_.orientation.toRotationMatrix() * Eigen::AngleAxisd(t * angle_, axis_).toRotationMatrix();
    place.translation() = from_.position + t * way_;
    return place;
  }
  /// Upper bound on the speed of the vertices, in metres per unit of t.
  double speed(const TriangleMesh& object) const { return (way_.norm() + turn(object)) * (1.0 + kRounding); }
  /// Upper bound on the way of a vertex by the rotation, metres.
  double turn(const TriangleMesh& object) const {
    double arm = 0.0;
    for (const Vector3& vertex : object.vertices) arm = std::max(arm, (vertex - axis_ * axis_.dot(vertex)).norm());
    return angle_ * arm;
  }
  const Vector3& way() const { return way_; }
  /// The rotation vector in the world, radians per unit of t; it is constant.
  Vector3 turning() const { return angle_ * (from_.orientation.toRotationMatrix() * axis_); }
  bool isHalfACircle() const { return angle_ > 3.14159265358979323846 - kHalfCircle; }

 private:
  /// Share by which bounds are raised to cover their rounding.
  static constexpr double kRounding = 1e-9;
  /// Within this angle of half a circle, radians, rounding decides the sense of the turn.
  static constexpr double kHalfCircle = 1e-6;

  const Pose& from_;
  Vector3 way_;
  double angle_ = 0.0;
  Vector3 axis_ = Vector3::UnitX();
};

}  // namespace glissade::check
