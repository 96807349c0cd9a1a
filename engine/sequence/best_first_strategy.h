#pragma once

#include "engine/sequence/sequence_strategy.h"

namespace glissade {

/// Finds the motions as GreedyStrategy does, and then the order of the steps that costs least, among all orders that
/// keep AssemblyStep::after: see cheapestOrder(). What a step costs is an expression that a person can change:
/// see StepCost. The motions are certified again for the new order.
class BestFirstStrategy final : public SequenceStrategy {
 public:
  AssemblyPlan plan(const SequenceQuestion& question, SequenceHost& host) override;
};

}  // namespace glissade
