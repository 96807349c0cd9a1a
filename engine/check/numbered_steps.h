#pragma once

#include <string>
#include <vector>

#include "engine/base/message.h"
#include "engine/check/plan_demands.h"

namespace glissade::check {

/// Consecutive motions among the same bodies: the steps of a plan, or of a group that has left and is taken apart.
struct StepList {
  const std::vector<Step>& steps;
  const std::vector<BodyId>& staying;  ///< ids
  Present there;                       ///< bodies that are there when the first step begins
};

/// A motion of a step with its bodies by number.
struct NumberedStep {
  const Step* step = nullptr;
  Group group{};
  Present there{};               ///< bodies that are there in the order of the list
  Present mayBeThere{};          ///< bodies that are there in some order that keeps all predecessors
  std::vector<Message> wrong{};  ///< errors for people; empty: none
};

std::vector<NumberedStep> numberedSteps(const Product& product, const StepList& list);

}  // namespace glissade::check
