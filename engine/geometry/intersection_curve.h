#pragma once

#include <vector>

#include "engine/geometry/triangle_mesh.h"

namespace glissade {

/// The curve in which the surfaces of two placed meshes meet, as ends of segments in the world frame. Each pair of
/// triangles that cut each other gives one segment, up to `mostSegments`. Coplanar triangles give none. For drawing: in
/// floating point, without a guarantee.
std::vector<Vector3> intersectionCurve(const TriangleMesh& a, const Pose& X_WA, const TriangleMesh& b, const Pose& X_WB,
                                       std::size_t mostSegments);

}  // namespace glissade
