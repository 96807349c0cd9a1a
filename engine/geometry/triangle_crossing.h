#pragma once

#include "engine/geometry/triangle_pair.h"

namespace glissade {

/// True if the triangles pass through each other by more than `near` (metres): corners of both are farther than that on
/// either side of the other's plane, and their common part is longer than ten times that. Touching triangles do not
/// cross, and coplanar ones neither. A triangle without area crosses each triangle that it meets.
bool trianglesCross(const Triangle& a, const Triangle& b, double near);

}  // namespace glissade
