#pragma once

#include <vector>

#include "engine/geometry/triangle_mesh.h"

namespace glissade {

/// What triangles pass over when they are turned about an axis by any angle: distances from the axis and heights along
/// it, of each.
struct TurnedTriangle {
  double nearest;   ///< distance from the axis
  double farthest;  ///< likewise
  double low;       ///< height
  double high;      ///< likewise
};

TurnedTriangle turned(const Vector3& a, const Vector3& b, const Vector3& c, const Vector3& point, const Vector3& axis);

/// Lower bound on the distance of the two for any angle between them, where the heights of the first grow by up to
/// `advance` (below 0: shrink) and its points are off by up to `off`.
double turnedDistance(const std::vector<TurnedTriangle>& moving, const std::vector<TurnedTriangle>& fixed,
                      double advance, double off);

}  // namespace glissade
