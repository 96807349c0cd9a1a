#pragma once

#include "engine/geometry/triangle_mesh.h"

namespace glissade::check {

/// The surface of the volume that a mesh sweeps on a straight motion: the boundaries of the prisms that its triangles
/// sweep, without faces between neighbouring prisms.
TriangleMesh sweptBy(const TriangleMesh& mesh, const Vector3& way);

/// True if the triangle passes over the point on a straight motion.
bool passesOver(const Vector3& a, const Vector3& b, const Vector3& c, const Vector3& way, const Vector3& point);

}  // namespace glissade::check
