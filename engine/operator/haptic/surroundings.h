#pragma once

#include "engine/collision/collision_query.h"

namespace glissade {

/// The obstacles about one configuration of the object.
struct Surroundings {
  Pose q;
  double clearance = 0.0;   ///< lower bound on the distance at q, metres; 0 in collision
  NearestObstacle nearest;  ///< nearest obstacle at q; body -1 where no obstacle is within reach
};

/// Searches within `reach` (metres, > 0). The query is cheap where no obstacle is that near.
inline Surroundings lookAround(CollisionQuery& query, const Pose& q, double reach) {
  if (query.clearAbove(q, reach)) return {q, reach, {}};
  const NearestObstacle nearest = query.nearestObstacle(q);
  return {q, nearest.distance, nearest};
}

}  // namespace glissade
