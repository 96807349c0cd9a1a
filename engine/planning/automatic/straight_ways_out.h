#pragma once

#include <vector>

#include "engine/base/stop_token.h"
#include "engine/planning/problem.h"

namespace glissade {

/// Directions in which an assembler tries to move the object at its start first: the axes of the world and the normals
/// of the object's large faces, both ways, no two alike. Unit vectors in the world frame.
std::vector<Vector3> likelyDirections(const Problem& problem);

/// Metres from a position of the object along a direction (unit) until the object's ball is clear of the obstacles'
/// box.
double distanceOut(const Problem& problem, const Vector3& from, const Vector3& direction);

/// Indices of the obstacles that stop the object first on its way straight out along the likely directions, ascending.
/// Empty where a direction is free: `query` (of the problem's world) certifies the required clearance (metres) on it.
std::vector<int> firstInTheWay(const Problem& problem, CollisionQuery& query, double required,
                               const StopToken& stop = {});

}  // namespace glissade
