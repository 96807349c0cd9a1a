#pragma once

#include "engine/geometry/triangle_mesh.h"

namespace glissade::check {

/// True if the convex hulls of two placed meshes are shown to be farther apart than `distance`: along one direction,
/// all vertices of one are beyond all vertices of the other by that much.
bool hullsAreClear(const TriangleMesh& a, const Pose& X_WA, const TriangleMesh& b, const Pose& X_WB, double distance);

}  // namespace glissade::check
