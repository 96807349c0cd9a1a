#pragma once

#include <vector>

#include "engine/base/stop_token.h"
#include "engine/planning/problem.h"

namespace glissade {

/// The directions that an assembler tries first to move the object at its start: the axes of the world and the normals
/// of the object's large faces, in both senses, without duplicates. Unit vectors in the world frame.
std::vector<Vector3> likelyDirections(const Problem& problem);

/// Distance from a position of the object along a direction (unit) until the object's ball is clear of the obstacles'
/// box, metres.
double distanceOut(const Problem& problem, const Vector3& from, const Vector3& direction);

/// Indices of the obstacles that stop the object first on straight motions along the likely directions, ascending.
/// Empty where a direction is free: `query` (of the problem's world) certifies the required clearance (metres) on it.
std::vector<int> firstInTheWay(const Problem& problem, CollisionQuery& query, double required,
                               const StopToken& stop = {});

}  // namespace glissade
