#pragma once

#include "engine/sequence/sequence_strategy.h"

namespace glissade {

// A search plans steps of one motion. In a finished plan, the motions of a fastener stack that follow each other are
// one step: nut, washer and bolt.

/// True if the motion of `group` belongs to the step of the motion of `before`, after which it comes: both are of one
/// fastener stack. `joints`: null: there are no stacks.
bool continuesStack(const BodyGroup& group, const BodyGroup& before, const JointRules* joints);

/// Joins the steps that continue the stack of the step before. The joined step is after all steps that one of its
/// motions is after. A number of steps that ends within a stack is rounded up, so that no proof claims a body that was
/// not there. A motion whose nearest body is thereby out of its proof is certified again; where that fails, as after a
/// stop, the plan stays as it is. Lines get the new numbers of their steps, and keep their own steps. Precondition:
/// each step has one motion.
void joinStacks(AssemblyPlan& plan, const SequenceQuestion& question, const StopToken& stop);

/// A step for each motion, without predecessors and lines, as a search resumes a plan.
AssemblyPlan splitStacks(AssemblyPlan plan);

}  // namespace glissade
