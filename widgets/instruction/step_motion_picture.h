#pragma once

#include <vector>

#include "engine/sequence/assembly_plan.h"
#include "engine/sequence/body_group.h"

namespace glissade {

/// Where what comes in a step is drawn: on its way, not far from its place.
struct StepMotionPicture {
  Pose moved;                ///< a body stands at moved * X_WB
  std::vector<Vector3> way;  ///< of the middle of what comes, world frame, from where it is drawn to its place
  double along = 0.0;        ///< size of what comes in the direction of its motion, metres
};

/// `apart`: how far from its place it is drawn at least, metres, where its way is that long. Precondition: the product
/// has the bodies of the step.
StepMotionPicture stepMotionPicture(const AssemblyStep& step, const AssembledProduct& product, double apart);

}  // namespace glissade
