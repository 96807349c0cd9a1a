#pragma once

#include <cstdint>
#include <optional>

#include "engine/collision/collision_query.h"
#include "engine/geometry/wrench.h"

namespace glissade {

/// The operator's state that is published for the planner. The latest one counts.
struct OperatorSample {
  Pose q_device;
  NearestObstacle nearest;  ///< nearest obstacle at q_device; distance 0 in collision
  std::uint64_t moves = 0;  ///< number of changes of q_device; an equal number means that the operator has not moved
  /// Force and torque that the operator feels, or would feel with a haptic device; shares of the device's maximum.
  Wrench guidance;
  std::optional<Pose> hand = std::nullopt;  ///< pose that the hand leads to, where obstacles stop the object before it
};

}  // namespace glissade
