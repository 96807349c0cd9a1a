#pragma once

#include "engine/sequence/sequence_strategy.h"

namespace glissade {

/// Finds the motions with GreedyStrategy, and then the order of steps with the least cost among the orders that keep
/// AssemblyStep::after (see cheapestOrder()). The user can edit the cost of a step (see StepCost). The motions are
/// certified again for the new order.
class BestFirstStrategy final : public SequenceStrategy {
 public:
  AssemblyPlan plan(const SequenceQuestion& question, SequenceHost& host) override;
};

}  // namespace glissade
