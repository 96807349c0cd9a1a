#pragma once

#include <vector>

#include "engine/geometry/triangle_mesh.h"

namespace glissade {

/// The plane of the points p with normal · p = offset; normal is a unit vector.
struct Plane {
  Vector3 normal = Vector3::UnitZ();
  double offset = 0.0;  ///< metres
};

/// The same plane in the frame of a body at X_WB.
Plane planeInBody(const Plane& plane_W, const Pose& X_WB);

/// Where a plane cuts a mesh whose vertices of equal position are one (welded()): closed polygons of the section of a
/// closed mesh, in the mesh's frame. Polygons of holes are among them: the even-odd rule tells inside from outside.
/// Vertices on the plane, up to what coordinates are rounded to, count as lying on the side of the normal. Open curves,
/// which only a mesh that is not closed has, are left out.
std::vector<std::vector<Vector3>> planeSection(const TriangleMesh& mesh, const Plane& plane);

}  // namespace glissade
