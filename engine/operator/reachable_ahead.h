#pragma once

#include "engine/operator/guidance.h"

namespace glissade {

/// Whether a hand moves the object freely from one pose to another: both ends may be in contact.
bool isFreeMotion(const Pose& from, const Pose& to, double objectRadius, CollisionQuery& object);

/// A pose to which a person leads the object next on a way: aheadInSight(), but no farther ahead than the object gets
/// there by a straight motion, by a turn and then a move, or by a move and then a turn. It is the first of the two
/// then. Where the object gets to no pose, it is aheadInSight(): the object slides on what it meets. `object`: a query
/// of the world.
std::optional<Pose> reachableAhead(const std::vector<Pose>& way, const Pose& q, const Se3Metric& metric, double ahead,
                                   CollisionQuery& sight, CollisionQuery& object);

}  // namespace glissade
