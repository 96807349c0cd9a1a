#pragma once

#include <vector>

#include "engine/base/stop_token.h"
#include "engine/geometry/triangle_mesh.h"

namespace glissade::check {

/// What triangles pass over when they are turned about an axis by any angle: distances from the axis and heights along
/// it, of each.
struct TurnedTriangle {
  double nearest;   ///< distance from the axis
  double farthest;  ///< likewise
  double low;       ///< height
  double high;      ///< likewise
};

TurnedTriangle turned(const Vector3& a, const Vector3& b, const Vector3& c, const Vector3& point, const Vector3& axis);

/// Lower bound on the distance of two points in them, for any angle between the two.
double apartTurned(const TurnedTriangle& a, const TurnedTriangle& b);

/// How far a motion that turns about an axis also goes along it, metres, and what it is off such a motion.
struct Rise {
  double least = 0.0;  ///< at most 0
  double most = 0.0;   ///< at least 0
  double off = 0.0;    ///< no point is farther from where an exact turn and rise have it
};

/// Lower bound on the distance of the two for any angle between them, where the heights of the first change by what the
/// rise says. 0 after a stop.
double turnedDistance(const std::vector<TurnedTriangle>& moving, const std::vector<TurnedTriangle>& fixed,
                      const Rise& rise, const StopToken& stop);

}  // namespace glissade::check
