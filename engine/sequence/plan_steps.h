#pragma once

#include <string>
#include <vector>

#include "engine/sequence/sequence_strategy.h"

namespace glissade {

std::vector<std::string> idsOf(const BodyGroup& bodies, const AssembledProduct& product);

/// The bodies of a step. Precondition: it is about this product.
BodyGroup groupOf(const AssemblyStep& step, const AssembledProduct& product);

/// The step that a group leaves by, proved when `afterSteps` had been carried out; without wave and predecessors.
AssemblyStep makeStep(const BodyGroup& group, const Removed& removed, const SequenceQuestion& question,
                      std::size_t afterSteps);

}  // namespace glissade
