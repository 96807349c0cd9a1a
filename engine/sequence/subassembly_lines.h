#pragma once

#include "engine/sequence/sequence_strategy.h"

namespace glissade {

/// Takes the groups of a plan apart after they have left, each in a frame of its own, until units are left: a unit is a
/// body, or bodies that joints make one. Of each group the largest unit stays. `question`: of the plan; its trial is
/// asked for lines, turns and short searches only. After a stop, lines are missing.
void addLines(AssemblyPlan& plan, const SequenceQuestion& question, SequenceHost& host);

/// Bodies of the plan that have left alone, as a unit, or with their insert: those that leave but for what remains in
/// groups. Where bodies of a group do not leave it, those that they are stuck to are not apart, either.
std::size_t bodiesApart(const AssemblyPlan& plan);

}  // namespace glissade
