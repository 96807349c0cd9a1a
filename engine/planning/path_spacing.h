#pragma once

#include <vector>

#include "engine/geometry/se3_metric.h"

namespace glissade {

/// Which poses of a path are drawn beside it.
struct PathSpacing {
  enum class By { None, Number, Distance };
  By by = By::Number;
  int number = 5;         ///< of By::Number: so many between the ends, equally far from each other
  double distance = 0.1;  ///< of By::Distance: metres from one to the next, with rotations as the metric counts them

  friend bool operator==(const PathSpacing&, const PathSpacing&) = default;
};

/// More are not drawn.
inline constexpr int kMostPathPoses = 200;

/// Those poses, without both ends of the path; at most kMostPathPoses, and then equally far from each other. Turns on
/// the spot count, so that a motion that only turns has poses, too.
std::vector<Pose> posesAlong(const std::vector<Pose>& way, const Se3Metric& metric, const PathSpacing& spacing);

}  // namespace glissade
