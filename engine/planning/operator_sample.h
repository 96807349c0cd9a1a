#pragma once

#include <cstdint>

#include "engine/collision/collision_query.h"

namespace glissade {

/// What the operator side publishes for the planner: latest wins.
struct OperatorSample {
  Pose q_device;
  NearestObstacle nearest;  ///< of q_device; distance 0 in collision
  std::uint64_t moves = 0;  ///< counts changes of q_device; equal means he has not moved
};

}  // namespace glissade
