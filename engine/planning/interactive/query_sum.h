#pragma once

#include "engine/collision/collision_query.h"

namespace glissade {

inline QueryCounts& operator+=(QueryCounts& sum, const QueryCounts& more) {
  sum.collision += more.collision;
  sum.distance += more.distance;
  sum.motion += more.motion;
  return sum;
}

}  // namespace glissade
