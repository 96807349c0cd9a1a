#pragma once

#include <string>
#include <vector>

#include "engine/sequence/sequence_strategy.h"

namespace glissade {

std::vector<std::string> idsOf(const BodyGroup& bodies, const AssembledProduct& product);

/// The bodies of a step. Precondition: it is about this product.
BodyGroup groupOf(const AssemblyStep& step, const AssembledProduct& product);

/// States how the group is taken against others while it moves on the step's path.
void addAllowances(AssemblyStep& step, const BodyGroup& group, const std::vector<BodyFit>& fits,
                   const AssembledProduct& product);

/// The step that a group leaves by, proved when `afterSteps` had been carried out; without wave and predecessors.
AssemblyStep makeStep(const BodyGroup& group, const Removed& removed, const SequenceQuestion& question,
                      std::size_t afterSteps);

/// The removal of a flexible body: a straight way out of the box of those that are there, of which nothing is proved.
AssemblyStep makeFlexibleStep(std::size_t body, const BodySet& present, const SequenceQuestion& question,
                              std::size_t afterSteps);

/// Rules whose first bodies are still there when the group leaves: all of them, or those that are demanded.
std::vector<std::size_t> heldBy(const BodyGroup& group, const BodySet& present, const OrderRules& rules,
                                bool knowledgeToo);

/// What joints hold the group by and has to leave before, ascending. `strict`: as of JointRules::holding().
BodyGroup heldByJoints(const BodyGroup& group, const BodySet& present, const SequenceQuestion& question, bool strict);

/// What a step at a place that a person demands does not keep: it leaves as the step `number`, from 1, and `falling`
/// fall.
std::vector<StepViolation> violationsOf(const BodyGroup& group, const BodySet& present, const BodyGroup& falling,
                                        std::size_t number, const SequenceQuestion& question);

}  // namespace glissade
