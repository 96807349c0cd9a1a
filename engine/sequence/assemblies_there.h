#pragma once

#include <vector>

#include "engine/sequence/sequence_strategy.h"

namespace glissade {

/// For each assembly of the file, its bodies that are in `present`; the smallest first. Assemblies with one such body,
/// and those that would cut a unit of the rules, are left out.
std::vector<BodyGroup> assembliesThere(const SequenceQuestion& question, const BodySet& present);

}  // namespace glissade
