#pragma once

#include "engine/geometry/triangle_mesh.h"

namespace glissade {

/// True if the convex hulls of the vertices of two placed meshes are farther apart than `distance` (>= 0), by the
/// algorithm of Gilbert, Johnson and Keerthi (1988). Conservative: true only where a plane separates them by that
/// distance.
bool hullsApart(const TriangleMesh& a, const Pose& X_WA, const TriangleMesh& b, const Pose& X_WB, double distance);

}  // namespace glissade
