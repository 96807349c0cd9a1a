#pragma once

#include <vector>

#include "engine/geometry/se3_metric.h"

namespace glissade {

/// Selects the poses of a path that are drawn beside it.
struct PathSpacing {
  enum class By { None, Number, Distance };
  By by = By::Number;
  int number = 5;         ///< for By::Number: number of poses between the ends, at equal distances
  double distance = 0.1;  ///< for By::Distance: distance between poses, metres in the metric, which includes rotations

  friend bool operator==(const PathSpacing&, const PathSpacing&) = default;
};

/// Most poses that are drawn.
inline constexpr int kMostPathPoses = 200;

/// The poses that are drawn, without both ends of the path. Where there would be more than kMostPathPoses, that many at
/// equal distances. Turns on the spot count, so that a motion that only turns has poses, too.
std::vector<Pose> posesAlong(const std::vector<Pose>& way, const Se3Metric& metric, const PathSpacing& spacing);

}  // namespace glissade
