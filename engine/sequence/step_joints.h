#pragma once

#include "engine/sequence/sequence_strategy.h"

namespace glissade {

/// Sets the joints that come apart when the group leaves `present` by the motion. Does nothing if the question has no
/// joints.
void setJoints(StepMotion& motion, const BodyGroup& group, const BodySet& present, const SequenceQuestion& question);

/// Adds to each step of the plan the joints that come apart by it, its turns and its task. Does nothing if the question
/// has no joints.
void addJoints(AssemblyPlan& plan, const SequenceQuestion& question);

/// Sum of the turns along a path that turns about one axis, without regard to their sense.
double turnsOf(const std::vector<PathPoint>& path);

}  // namespace glissade
