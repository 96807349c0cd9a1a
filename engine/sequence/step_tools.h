#pragma once

#include "engine/sequence/sequence_strategy.h"

namespace glissade {

/// Finds for each step of a fastener whether a tool can be brought on at its beginning: the tools of the body are tried
/// in their order, each with its handle in all positions, against the bodies that are there, the fastener excepted. The
/// first that nothing blocks is the step's; where all are blocked it is the preferred one, with the fewest bodies in
/// its way. After a stop, or where the body has no head, it is not asked.
void addTools(AssemblyPlan& plan, const SequenceQuestion& question, SequenceHost& host);

}  // namespace glissade
