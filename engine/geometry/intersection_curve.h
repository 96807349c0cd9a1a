#pragma once

#include <vector>

#include "engine/geometry/triangle_mesh.h"

namespace glissade {

/// Where the surfaces of two placed meshes meet, as ends of segments in the world frame: one segment for each pair of
/// triangles that cut each other, at most `mostSegments` of them. Triangles in one plane give none. For drawing: in
/// floating point, without a guarantee.
std::vector<Vector3> intersectionCurve(const TriangleMesh& a, const Pose& X_WA, const TriangleMesh& b, const Pose& X_WB,
                                       std::size_t mostSegments);

}  // namespace glissade
