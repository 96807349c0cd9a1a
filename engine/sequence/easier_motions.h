#pragma once

#include "engine/sequence/sequence_strategy.h"

namespace glissade {

/// Gives steps another straight motion where, at their place in the order, the body slides less along what it touches,
/// or is not brought from below. A part that was pushed out sideways while another one lay on it is lifted off where
/// that one has left before. True if a motion has changed: `after` of the steps is to be found anew (addPrecedence()).
bool takeEasierMotions(AssemblyPlan& plan, const SequenceQuestion& question, const StopToken& stop);

}  // namespace glissade
