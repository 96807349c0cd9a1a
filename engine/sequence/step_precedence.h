#pragma once

#include "engine/sequence/sequence_strategy.h"

namespace glissade {

/// Finds for every step which steps have to be carried out before: those of bodies that would be in the way of its
/// motion, and those that rules ask for and that are earlier. After a stop: all earlier ones. The others may be carried
/// out later: the step states its allowances against their bodies, too.
void addPrecedence(AssemblyPlan& plan, const SequenceQuestion& question, SequenceHost& host);

/// The same where nobody asks: all earlier ones.
void demandAllEarlier(AssemblyPlan& plan);

}  // namespace glissade
