#pragma once

#include <string>
#include <vector>

#include "engine/sequence/sequence_strategy.h"

namespace glissade {

std::vector<BodyId> idsOf(const BodyGroup& bodies, const AssembledProduct& product);

/// The bodies of a motion, ascending. Precondition: the motion belongs to this product.
BodyGroup groupOf(const StepMotion& motion, const AssembledProduct& product);
/// The bodies of a step of one motion.
inline BodyGroup groupOf(const AssemblyStep& step, const AssembledProduct& product) {
  return groupOf(step.only(), product);
}

/// States the allowances of the group against other bodies on the path of the motion.
void addAllowances(StepMotion& motion, const BodyGroup& group, const std::vector<Fit>& fits,
                   const AssembledProduct& product);

/// The motion by which a group leaves `present`, proved after `afterSteps` steps. Its tool is that of a single body. A
/// body of a screwed joint that leaves after the joint was opened needs none.
StepMotion makeMotion(const BodyGroup& group, const Removed& removed, const SequenceQuestion& question,
                      const BodySet& present, std::size_t afterSteps);

/// The removal of a flexible body: a straight motion out of the box of the present bodies, without a proof.
StepMotion makeFlexibleMotion(std::size_t body, const BodySet& present, const SequenceQuestion& question,
                              std::size_t afterSteps);

/// Bodies that have to leave before the group and are still there, by all order rules (`knowledgeToo`) or the demanded
/// ones.
std::vector<std::size_t> heldBy(const BodyGroup& group, const BodySet& present, const OrderRules& rules,
                                bool knowledgeToo);

/// Bodies that hold the group by joints and have to leave before it, ascending. `strict`: see JointRules::holding().
BodyGroup heldByJoints(const BodyGroup& group, const BodySet& present, const SequenceQuestion& question, bool strict);

/// The rules that a step at a demanded place breaks if it leaves as step `number`, from 1, and the bodies `falling`
/// fall.
std::vector<StepViolation> violationsOf(const BodyGroup& group, const BodySet& present, const BodyGroup& falling,
                                        std::size_t number, const SequenceQuestion& question);

}  // namespace glissade
