#pragma once

#include <vector>

#include "engine/base/stop_token.h"
#include "engine/geometry/triangle_mesh.h"

namespace glissade::evidence {

/// Ranges of the distances from an axis and of the heights along it that a triangle covers when it turns about the axis
/// by any angle.
struct TurnedTriangle {
  double nearest;   ///< distance from the axis
  double farthest;  ///< distance from the axis
  double low;       ///< height
  double high;      ///< height
};

TurnedTriangle turned(const Vector3& a, const Vector3& b, const Vector3& c, const Vector3& point, const Vector3& axis);

/// Lower bound on the distance of two points of them, for any angle between the two.
double apartTurned(const TurnedTriangle& a, const TurnedTriangle& b);

/// The translation along the axis of a motion that turns about it, metres, and its deviation from such a motion.
struct Rise {
  double least = 0.0;  ///< at most 0
  double most = 0.0;   ///< at least 0
  double off = 0.0;    ///< upper bound on the distance of a point from its place in an exact turn and rise
};

/// Lower bound on the distance of the two for any angle between them, when the first rises within `rise`. 0 after a
/// stop.
double turnedDistance(const std::vector<TurnedTriangle>& moving, const std::vector<TurnedTriangle>& fixed,
                      const Rise& rise, const StopToken& stop);

}  // namespace glissade::evidence
