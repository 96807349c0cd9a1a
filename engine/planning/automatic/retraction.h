#pragma once

#include "engine/planning/problem.h"

namespace glissade {

/// Moves a configuration away from near obstacles until the object's clearance is at least `clearance` (metres). It
/// takes Newton steps on the distance to the nearest obstacle. Each step is the smallest motion in SE(3) that opens the
/// contact (translation and turn about the reference point, weighted by `radius`). Opposite contacts alternate, so that
/// the object ends up between them. With an eroded object the distance is defined up to the depth of the erosion inside
/// the obstacles, so that a colliding configuration can be retracted. Returns nothing where a few steps do not reach
/// the clearance.
std::optional<Pose> retracted(CollisionQuery& query, const Pose& q, double clearance, double radius);

}  // namespace glissade
