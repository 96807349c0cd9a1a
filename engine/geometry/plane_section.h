#pragma once

#include <vector>

#include "engine/geometry/triangle_mesh.h"

namespace glissade {

/// The plane of the points p with normal · p = offset; normal is a unit vector.
struct Plane {
  Vector3 normal = Vector3::UnitZ();
  double offset = 0.0;  ///< metres
};

/// The plane in the frame of a body at X_WB.
Plane planeInBody(const Plane& plane_W, const Pose& X_WB);

/// The section of a mesh, whose vertices of equal position are merged (welded()), by a plane: closed polygons in the
/// mesh's frame. They include polygons of holes; the even-odd rule distinguishes inside and outside. Vertices on the
/// plane, within the rounding of coordinates, count as lying on the side of the normal. Open curves, which only open
/// meshes have, are left out.
std::vector<std::vector<Vector3>> planeSection(const TriangleMesh& mesh, const Plane& plane);

}  // namespace glissade
