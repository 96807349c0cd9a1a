#pragma once

#include "engine/planning/problem.h"

namespace glissade {

/// Moves a configuration away from what is near until the object's clearance is at least `clearance`
/// (metres): Newton's steps on the distance to the nearest obstacle, each the least motion in SE(3)
/// that opens the contact (translation and turn about the reference point, weighed by `radius`).
/// Opposite contacts take turns, so that the object ends up between them. With an eroded object the
/// distance is defined to the depth of the erosion inside the obstacles: that is how a colliding
/// configuration is retracted. Nothing where it does not get there within a few steps.
std::optional<Pose> retracted(CollisionQuery& query, const Pose& q, double clearance, double radius);

}  // namespace glissade
