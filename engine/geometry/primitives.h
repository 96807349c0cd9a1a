#pragma once

#include "engine/geometry/triangle_mesh.h"

namespace glissade {

/// A box of the given edge lengths, centred on the origin.
TriangleMesh makeBox(const Vector3& size);

/// A cylinder along z, centred on the origin. The polygon is circumscribed: the mesh contains the
/// true cylinder, so a motion certified against the mesh is free of the cylinder.
TriangleMesh makeCylinder(double radius, double length, int segments = 48);

/// A sphere about the origin, which the mesh contains (subdivided icosahedron).
TriangleMesh makeSphere(double radius, int subdivisions = 3);

}  // namespace glissade
