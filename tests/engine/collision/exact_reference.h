#pragma once

#include <vector>

#include "engine/places/rigid_body.h"

namespace glissade::reference {

/// An independent collision test: every pair of triangles with CGAL's exact predicates, and containment by counting
/// crossings of a random ray. Slow, and shares no code with the engine's.
bool collides(const std::vector<RigidBody>& obstacles, const TriangleMesh& object, const Pose& X_WB);

/// Distance of the surfaces by every pair of triangles: vertices against faces, edges against edges.
double surfaceDistance(const std::vector<RigidBody>& obstacles, const TriangleMesh& object, const Pose& X_WB);

/// Distance of a point from a surface.
double pointDistance(const TriangleMesh& surface, const Vector3& p);

}  // namespace glissade::reference
