#pragma once

#include <optional>
#include <vector>

#include "engine/sequence/sequence_strategy.h"

namespace glissade {

/// A step, and the bodies that were there when each of its motions was proved.
struct ProvedStep {
  AssemblyStep step;
  std::vector<BodySet> proved;
};

/// The steps of the plan.
std::vector<ProvedStep> provedSteps(const AssemblyPlan& plan, const SequenceQuestion& question);
/// The steps of the plan in an order, which lists their indices; `after` counts in it.
std::vector<ProvedStep> provedSteps(const AssemblyPlan& plan, const std::vector<std::size_t>& order,
                                    const SequenceQuestion& question);

/// The steps in this order, each certified against the bodies that are there then; nothing if one is not certified.
/// `after` of each step has to count in this order. `refused`: receives the place of the step that is not certified;
/// null: it is not asked for.
std::optional<std::vector<AssemblyStep>> certifiedInOrder(std::vector<ProvedStep> steps,
                                                          const SequenceQuestion& question, const StopToken& stop,
                                                          std::size_t* refused = nullptr);

/// True if the motion ends outside of the box of the bodies of `others`, as every removal does.
bool endsOutside(const StepMotion& motion, const BodySet& others, const AssembledProduct& product);

}  // namespace glissade
