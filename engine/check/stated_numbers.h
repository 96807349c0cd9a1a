#pragma once

#include <optional>
#include <vector>

#include "engine/base/message.h"
#include "engine/check/evidence_names.h"
#include "engine/check/numbered_steps.h"
#include "engine/check/plan_verdict.h"
#include "engine/evidence/placed_bodies.h"

namespace glissade::check {

/// The values with which the numbers of a step are compared.
struct NumbersQuestion {
  const NumberedStep& numbered;
  const StepVerdict& verdict;  ///< verdict on its motion and allowances
  const Product& product;
  std::optional<double> required{};  ///< metres; nothing: the plan's clearance is not compared
  double farthest = 0.0;             ///< metres: upper bound on the distance of its bodies from a body that is there
  PlacedBodies& placed;
};

/// Numbers stated by the step that contradict its motion, its allowances or the product, for people: the number, its
/// key in the file, and the right value.
std::vector<Message> wrongNumbers(const NumbersQuestion& question);

}  // namespace glissade::check
