#pragma once

#include <vector>

#include "engine/planning/problem.h"

namespace glissade {

/// The configurations that the goal's trees grow from: the goal itself, or for "out" the free ones among six, reached
/// from the start straight along each axis out of the obstacles' box, nearest first, as far as the bounds allow. Empty
/// when "out" cannot be reached within the bounds.
std::vector<Pose> goalRoots(const Problem& problem, CollisionQuery& query);

}  // namespace glissade
