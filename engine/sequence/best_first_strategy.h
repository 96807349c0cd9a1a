#pragma once

#include "engine/sequence/sequence_strategy.h"

namespace glissade {

/// Finds the motions as GreedyStrategy does, and then the order of the steps that costs least, among all orders that
/// keep AssemblyStep::after: see cheapestOrder(). A step costs its length by the product's size; 1 where the direction
/// of the end differs from that of the step before; 1 where it is another kind of fastener (another tool); and 10 for
/// each body that would tip or fall. The motions are certified again for the new order.
class BestFirstStrategy final : public SequenceStrategy {
 public:
  AssemblyPlan plan(const SequenceQuestion& question, SequenceHost& host) override;
};

}  // namespace glissade
