#pragma once

#include "engine/sequence/sequence_strategy.h"

namespace glissade {

/// Takes the groups of a plan apart after they have left, each in a frame of the group, down to units: a unit is a
/// body, or bodies that joints bond. The unit that suits as base stays (baseOf()). `question`: the question of the
/// plan; its trial is used for lines, turns and short searches only. After a stop, lines are missing.
void addLines(AssemblyPlan& plan, const SequenceQuestion& question, SequenceHost& host);

/// Number of bodies of the plan that have left alone or as a unit. Bodies that remain in groups do not count, and if a
/// body does not leave a group, neither do the bodies of the group that stay.
std::size_t bodiesApart(const AssemblyPlan& plan);

}  // namespace glissade
