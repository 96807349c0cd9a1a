#pragma once

#include <optional>
#include <vector>

#include "engine/sequence/sequence_strategy.h"

namespace glissade {

/// A step of one motion, and the bodies that were there when its motion was proved.
struct ProvedStep {
  AssemblyStep step;
  BodySet proved;
};

/// The steps of the plan. Precondition: each has one motion.
std::vector<ProvedStep> provedSteps(const AssemblyPlan& plan, const SequenceQuestion& question);

/// The steps in this order, each certified against the bodies that are there then; nothing if one is not certified.
/// `after` of each step has to count in this order.
std::optional<std::vector<AssemblyStep>> certifiedInOrder(std::vector<ProvedStep> steps,
                                                          const SequenceQuestion& question, const StopToken& stop);

}  // namespace glissade
