#pragma once

#include "engine/sequence/sequence_strategy.h"

namespace glissade {

/// Says of each step of the plan which joints come apart by it, how far it turns, and which steps are one task.
/// Nothing where the question has no joints.
void addJoints(AssemblyPlan& plan, const SequenceQuestion& question);

/// Turns about the axis of the path, whatever their sense: of one that turns about one axis.
double turnsOf(const std::vector<PathPoint>& path);

}  // namespace glissade
