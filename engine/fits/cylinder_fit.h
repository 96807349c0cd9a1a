#pragma once

#include <optional>
#include <vector>

#include "engine/geometry/pose.h"

namespace glissade {

struct FittedCylinder {
  Vector3 point;
  Vector3 direction;  ///< unit
  double radius = 0.0;

  double distanceFromAxis(const Vector3& p) const { return (p - point).cross(direction).norm(); }
};

/// The least squares' cylinder through the points, from the normals of its facets. Nothing if the normals do not turn
/// about one axis, or if a point is farther from it than `tolerance` (metres).
std::optional<FittedCylinder> fitCylinder(const std::vector<Vector3>& points, const std::vector<Vector3>& normals,
                                          double tolerance);

}  // namespace glissade
