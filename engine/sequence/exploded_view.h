#pragma once

#include "engine/sequence/assembly_plan.h"
#include "engine/sequence/body_group.h"

namespace glissade {

/// By how much each body is moved in the exploded view, metres, world frame; zero for bodies that the plan does not
/// remove. The last body that leaves is moved first. A body is moved with the body that it fits or is nearest to, and
/// on in the direction in which it leaves, until its bounding box is clear of those of all bodies that were moved
/// before. It is a picture: nothing is proved of it. Precondition: the plan is about this product.
std::vector<Vector3> explodedOffsets(const AssembledProduct& product, const AssemblyPlan& plan);

}  // namespace glissade
