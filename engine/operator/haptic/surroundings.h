#pragma once

#include "engine/collision/collision_query.h"

namespace glissade {

/// What is known of the obstacles about one configuration of the object.
struct Surroundings {
  Pose q;
  double clearance = 0.0;   ///< lower bound on the distance at q, metres; 0 in collision
  NearestObstacle nearest;  ///< at q; body -1 where no obstacle is within reach
};

/// Looks no farther than `reach` (metres, > 0): where nothing is that near, that answer is cheap.
inline Surroundings lookAround(CollisionQuery& query, const Pose& q, double reach) {
  if (query.clearAbove(q, reach)) return {q, reach, {}};
  const NearestObstacle nearest = query.nearestObstacle(q);
  return {q, nearest.distance, nearest};
}

}  // namespace glissade
