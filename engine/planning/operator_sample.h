#pragma once

#include <cstdint>
#include <optional>

#include "engine/collision/collision_query.h"
#include "engine/geometry/wrench.h"

namespace glissade {

/// What the operator side publishes for the planner: latest wins.
struct OperatorSample {
  Pose q_device;
  NearestObstacle nearest;  ///< of q_device; distance 0 in collision
  std::uint64_t moves = 0;  ///< counts changes of q_device; equal means he has not moved
  Wrench guidance;          ///< what he feels, or would with a device that pushes back; shares of its strongest
  std::optional<Pose> hand = std::nullopt;  ///< where the hand leads to, where obstacles stop the object before it
};

}  // namespace glissade
