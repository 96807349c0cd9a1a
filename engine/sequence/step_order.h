#pragma once

#include <variant>
#include <vector>

#include "engine/sequence/sequence_strategy.h"

namespace glissade {

// Steps of a plan in another order, with the motions that they have. An order lists the indices of the steps.

/// Lengthens the path along its last displacement until it ends outside of the box of `others`. True if it has changed.
bool lengthen(StepMotion& motion, const BodySet& others, const AssembledProduct& product);

/// Two steps of a plan that cannot change their order.
struct OrderConflict {
  std::size_t first = 0;  ///< index of the step that has to be carried out before `then`; `then`: no other step
  std::size_t then = 0;
  Message reason{};  ///< names the bodies
};

/// The finished plan with its steps in another order, without a search: every motion is as before, or longer. Tools,
/// joints and falling bodies are those of the new order.
std::variant<AssemblyPlan, OrderConflict> withOrder(AssemblyPlan plan, const std::vector<std::size_t>& order,
                                                    const SequenceQuestion& question, SequenceHost& host);

}  // namespace glissade
