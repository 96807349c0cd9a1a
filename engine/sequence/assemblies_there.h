#pragma once

#include <vector>

#include "engine/sequence/sequence_strategy.h"

namespace glissade {

/// What is still there of each assembly of the file, where that is several bodies and no unit of the rules is cut; the
/// smallest first.
std::vector<BodyGroup> assembliesThere(const SequenceQuestion& question, const BodySet& present);

}  // namespace glissade
