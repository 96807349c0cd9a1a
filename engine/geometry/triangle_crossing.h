#pragma once

#include "engine/geometry/triangle_pair.h"

namespace glissade {

/// The triangles pass through each other by more than `near` (metres): corners of both are farther than that on either
/// side of the other one's plane, and what they have in common is longer than ten times that. Triangles that touch do
/// not cross, and neither do those in one plane. A triangle without area crosses what it meets.
bool trianglesCross(const Triangle& a, const Triangle& b, double near);

}  // namespace glissade
