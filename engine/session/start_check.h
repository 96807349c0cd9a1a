#pragma once

#include "engine/base/result.h"
#include "engine/planning/problem.h"

namespace glissade {

/// Checks whether a planner may start: the bounds are valid, start and goal lie in them and keep the required
/// clearance, and "out" can be reached within the bounds. Errors: InCollision, which names the body; Usage otherwise.
Outcome checkStart(const Problem& problem, double requiredClearance);

/// Checks that a milestone is in the workspace and that the object is free there. Errors: MalformedInput for a
/// milestone that is outside; NoPath, which names the body or the place.
Outcome checkMilestone(const Problem& problem, CollisionQuery& query, const Pose& q);

/// Checks all milestones that a person has set, for strategies that pass through them. Otherwise another milestone
/// would be drawn without notice. The error names the milestone in the file.
Outcome checkMilestones(const Problem& problem);

}  // namespace glissade
