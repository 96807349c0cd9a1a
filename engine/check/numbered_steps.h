#pragma once

#include <string>
#include <vector>

#include "engine/check/plan_demands.h"

namespace glissade::check {

/// Steps that follow each other among the same bodies: of a plan, or of a group that has left and is taken apart.
struct StepList {
  const std::vector<Step>& steps;
  const std::vector<std::string>& staying;  ///< ids
  Present there;                            ///< when the first step begins
};

/// A step by numbers of bodies.
struct NumberedStep {
  const Step* step = nullptr;
  Group group{};
  Present there{};                   ///< in the order of the list
  Present mayBeThere{};              ///< in any order that keeps what has to be carried out before
  std::vector<std::string> wrong{};  ///< for people; empty: nothing is
  std::size_t earlier = 0;           ///< steps of the list before it
};

std::vector<NumberedStep> numberedSteps(const Product& product, const StepList& list);

}  // namespace glissade::check
