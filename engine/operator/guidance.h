#pragma once

#include <optional>
#include <vector>

#include "engine/collision/collision_query.h"
#include "engine/geometry/se3_metric.h"
#include "engine/geometry/wrench.h"

namespace glissade {

/// Strengths and target of the operator's guidance.
///
/// Wrenches of guidance are shares: a force of length 1 is the maximum that a device renders, and a torque of length 1
/// is that force at a lever of the object's radius.
struct Guidance {
  double repulsion = 0.0;      ///< repulsion of the nearest obstacle at contact, in [0, 1]
  double attraction = 0.0;     ///< largest attraction to the target, in [0, 1]
  double distance = 0.0;       ///< range of the repulsion, metres
  std::optional<Pose> target;  ///< configuration ahead on the path, or the next milestone; nothing: no attraction
};

/// The force away from the nearest obstacle, at the nearest point of the object: repulsion * (1 - gap / distance)^2, so
/// that it begins smoothly and is never more than `repulsion`. Zero without an obstacle within the distance, and in
/// collision, where there is no direction.
Wrench repulsion(const Guidance& guidance, const Pose& X_WB, const NearestObstacle& nearest, double objectRadius);

/// The wrench of a spring to the target: linear near it, never more than `attraction`.
Wrench attraction(const Guidance& guidance, const Pose& X_WB, double objectRadius);

/// Force and torque, each shortened to a length of at most 1 in the same direction.
Wrench saturated(const Wrench& shares);

/// The whole guidance, which is displayed where no device renders it.
Wrench guidanceWrench(const Guidance& guidance, const Pose& X_WB, const NearestObstacle& nearest, double objectRadius);

/// The point of the way (straight motions between consecutive configurations) that lies `ahead` (metres in the metric)
/// of its point nearest to q; the end of the way where it is shorter. Nothing for an empty way.
std::optional<Pose> aheadOnWay(const std::vector<Pose>& way, const Pose& q, const Se3Metric& metric, double ahead);

/// As aheadOnWay(), but the straight line between the positions meets no obstacle: the point is less far ahead where it
/// would. Where none of these is in sight it is the visible corner of the way nearest to q. Nothing where no corner is
/// in sight. `sight`: a query of pointWorld(). Where the reference point is in an obstacle, sight does not count.
std::optional<Pose> aheadInSight(const std::vector<Pose>& way, const Pose& q, const Se3Metric& metric, double ahead,
                                 CollisionQuery& sight);

/// The obstacles of the world with an object that is nearly a point. They are not prepared again.
CollisionWorldPtr pointWorld(const CollisionWorld& world);

}  // namespace glissade
