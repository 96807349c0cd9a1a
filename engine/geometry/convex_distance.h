#pragma once

#include "engine/geometry/triangle_mesh.h"

namespace glissade {

/// The convex hulls of the vertices of two placed meshes are farther apart than `distance` (>= 0), by the algorithm of
/// Gilbert, Johnson and Keerthi (1988). True only where a plane between them shows it.
bool hullsApart(const TriangleMesh& a, const Pose& X_WA, const TriangleMesh& b, const Pose& X_WB, double distance);

}  // namespace glissade
