#pragma once

#include <optional>
#include <vector>

#include "engine/geometry/pose.h"

namespace glissade {

struct FittedCircle {
  Vector3 middle;  ///< at the height of the first point
  double radius = 0.0;
};

/// The circle through points that are seen along an axis, by least squares of a linear equation (I. Kasa, 1976).
/// `axis`: unit. Nothing if there is no such circle.
std::optional<FittedCircle> fitCircle(const std::vector<Vector3>& points, const Vector3& axis);

}  // namespace glissade
