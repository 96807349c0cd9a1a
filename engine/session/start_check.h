#pragma once

#include "engine/base/result.h"
#include "engine/planning/problem.h"

namespace glissade {

/// Whether a planner may start: bounds are sound, start and goal lie in them and keep the required
/// clearance, "out" can be reached within the bounds. InCollision names the body; Usage otherwise.
Outcome checkStart(const Problem& problem, double requiredClearance);

}  // namespace glissade
