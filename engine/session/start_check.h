#pragma once

#include "engine/base/result.h"
#include "engine/planning/problem.h"

namespace glissade {

/// Whether a planner may start: bounds are sound, start and goal lie in them and keep the required
/// clearance, "out" can be reached within the bounds. InCollision names the body; Usage otherwise.
Outcome checkStart(const Problem& problem, double requiredClearance);

/// Whether the object is free in every milestone that a person has set, for strategies that pass through them: another
/// one would be drawn silently. NoPath names the body or the place.
Outcome checkMilestones(const Problem& problem);

}  // namespace glissade
