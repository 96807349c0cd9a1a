#pragma once

#include <cstddef>
#include <vector>

#include "engine/geometry/triangle_mesh.h"

namespace glissade {

struct SurfacePoint {
  Vector3 p;
  Vector3 normal;  ///< unit, outwards
};

/// `count` points, spread evenly over the area of the mesh; the same points at each call. Empty if the mesh has no
/// area.
std::vector<SurfacePoint> surfacePoints(const TriangleMesh& mesh, std::size_t count);

}  // namespace glissade
