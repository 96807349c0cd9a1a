#pragma once

#include <optional>

#include "engine/check/evidence_names.h"
#include "engine/check/motion_bodies.h"
#include "engine/check/numbered_steps.h"
#include "engine/check/plan_verdict.h"
#include "engine/evidence/placed_bodies.h"

namespace glissade::check {

/// Data for the judgement of a plan's steps. Refers to all members; shared by threads.
struct StepTools {
  const Product& product;  ///< with a person's statements, and the bends that only the plan states
  const Plan& plan;
  std::optional<double> required;  ///< clearance, metres; nothing: the usual one for the size of each body
  PlacedBodies& placed;
  MotionBodies& prepared;
  const WorkWatch& watch;
};

/// The verdict on one step: each of its bodies along the common motion, against all bodies that may be there. The
/// motion of a flexible body is not judged.
StepVerdict judgeStep(const NumberedStep& numbered, const StepTools& tools);

}  // namespace glissade::check
