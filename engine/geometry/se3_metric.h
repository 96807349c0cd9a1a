#pragma once

#include <cmath>

#include "engine/geometry/pose.h"

namespace glissade {

/// Distance between configurations, in metres: sqrt(|dp|^2 + (r * angle)^2), where r is the object's radius, so that a
/// rotation counts as the motion of the object's farthest point (the metric of paper 1's software).
class Se3Metric {
 public:
  explicit Se3Metric(double objectRadius) : radius_(objectRadius) {}

  double radius() const { return radius_; }

  double distance(const Pose& a, const Pose& b) const {
    const double rotation = radius_ * angleBetween(a.orientation, b.orientation);
    return std::sqrt((a.position - b.position).squaredNorm() + rotation * rotation);
  }

 private:
  double radius_;
};

}  // namespace glissade
