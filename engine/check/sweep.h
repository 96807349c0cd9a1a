#pragma once

#include "engine/geometry/triangle_mesh.h"

namespace glissade::check {

/// What a mesh passes over on a straight way: the boundary of all prisms that its triangles sweep, together. The faces
/// between two prisms that are beside each other are left out.
TriangleMesh sweptBy(const TriangleMesh& mesh, const Vector3& way);

/// Whether a triangle on a straight way passes over the point.
bool passesOver(const Vector3& a, const Vector3& b, const Vector3& c, const Vector3& way, const Vector3& point);

}  // namespace glissade::check
