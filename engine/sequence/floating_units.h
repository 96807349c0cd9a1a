#pragma once

#include "engine/sequence/sequence_strategy.h"

namespace glissade {

/// Replaces steps that put bodies into the air. Where a step of the order of removal takes away the last body that
/// holds others to the base, these others leave before it: alone, or as one group, or together with that body and what
/// blocks them. In
/// assembly the group is built on the bench (addLines()) and comes to the product as one. Steps whose bodies have a
/// demanded place or motion, or are held by joints, are kept. True if steps have changed: their `after` is to be found
/// anew (addPrecedence()).
bool liftFloatingUnits(AssemblyPlan& plan, const SequenceQuestion& question, SequenceHost& host);

}  // namespace glissade
