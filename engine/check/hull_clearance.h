#pragma once

#include "engine/geometry/triangle_mesh.h"

namespace glissade::check {

/// The convex hulls of two placed meshes are farther apart than `distance`: a direction is found along which all
/// vertices of one are so far beyond all of the other. False where none is found.
bool hullsAreClear(const TriangleMesh& a, const Pose& X_WA, const TriangleMesh& b, const Pose& X_WB, double distance);

}  // namespace glissade::check
