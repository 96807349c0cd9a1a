#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/check/numbered_steps.h"
#include "engine/check/placed_bodies.h"
#include "engine/check/plan_verdict.h"

namespace glissade::check {

/// What the numbers of a step are compared with.
struct NumbersQuestion {
  const NumberedStep& numbered;
  const StepVerdict& verdict;  ///< of its motion and allowances
  const Product& product;
  std::optional<double> required{};  ///< metres; nothing: the plan's need not be compared
  double farthest = 0.0;             ///< metres: its bodies get at least so near to one that is there
  PlacedBodies& placed;
};

/// Numbers that the step states and that its motion, its allowances or the product do not have, for people: the number,
/// its key in the file, and the right value.
std::vector<std::string> wrongNumbers(const NumbersQuestion& question);

}  // namespace glissade::check
