#pragma once

#include <optional>
#include <vector>

#include "engine/collision/collision_query.h"
#include "engine/geometry/se3_metric.h"
#include "engine/geometry/wrench.h"

namespace glissade {

/// What guides the operator's hand, and how strongly.
///
/// Wrenches of guidance are shares: a force of length 1 is the strongest that a device renders, a torque
/// of length 1 is that force at a lever of the object's radius.
struct Guidance {
  double repulsion = 0.0;      ///< of the nearest obstacle, at contact; in [0, 1]
  double attraction = 0.0;     ///< to the target, at most; in [0, 1]
  double distance = 0.0;       ///< metres: obstacles farther away do not repel
  std::optional<Pose> target;  ///< ahead on the path, or the next milestone; nothing: nothing attracts
};

/// Away from the nearest obstacle, at the nearest point of the object: repulsion * (1 - gap / distance)^2,
/// so that it begins smoothly and is never more than `repulsion`. Zero without an obstacle within the
/// distance, and in collision, where there is no direction.
Wrench repulsion(const Guidance& guidance, const Pose& X_WB, const NearestObstacle& nearest, double objectRadius);

/// A capped spring to the target: linear near it, never more than `attraction`.
Wrench attraction(const Guidance& guidance, const Pose& X_WB, double objectRadius);

/// Force and torque each shortened to a length of at most 1, directions kept.
Wrench saturated(const Wrench& shares);

/// All of it: what is shown where no device renders it.
Wrench guidanceWrench(const Guidance& guidance, const Pose& X_WB, const NearestObstacle& nearest, double objectRadius);

/// The point of the way (straight motions between consecutive configurations) that lies `ahead` (metres
/// in the metric) of its point nearest to q; its end where less is left. Nothing for an empty way.
std::optional<Pose> aheadOnWay(const std::vector<Pose>& way, const Pose& q, const Se3Metric& metric, double ahead);

}  // namespace glissade
