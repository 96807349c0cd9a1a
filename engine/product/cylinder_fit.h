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

/// The cylinder through the points in the least squares' sense, from the normals of its facets: nothing where the
/// normals do not turn about one axis, or a point is farther than `tolerance` (metres) off.
std::optional<FittedCylinder> fitCylinder(const std::vector<Vector3>& points, const std::vector<Vector3>& normals,
                                          double tolerance);

}  // namespace glissade
