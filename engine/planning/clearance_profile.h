#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "engine/base/work_watch.h"
#include "engine/collision/collision_query.h"
#include "engine/geometry/se3_metric.h"

namespace glissade {

/// The exact distance to the nearest obstacle at one place of a way.
struct ClearanceSample {
  double share = 0.0;  ///< share of the way's metric length that lies before the place, in [0, 1]
  Pose q;
  NearestObstacle nearest;
};

/// Distances along a way of straight motions.
struct ClearanceProfile {
  std::vector<ClearanceSample> samples;  ///< in the order of the way; each configuration of the way has a sample
  bool complete = true;                  ///< false after a stop

  /// Index of the sample of the smallest distance, the first of equal ones; nothing where there is no sample.
  std::optional<std::size_t> tightest() const;
};

/// Samples all configurations of `way`, and between them places spread evenly by the metric, about `count` in all. A
/// sampled profile proves nothing between its samples: the path's certificate proves the motion.
ClearanceProfile clearanceProfile(CollisionQuery& query, const std::vector<Pose>& way, const Se3Metric& metric,
                                  std::size_t count, const WorkWatch& watch = {});

}  // namespace glissade
