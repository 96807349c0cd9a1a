#pragma once

#include <cstddef>
#include <vector>

#include "engine/geometry/triangle_mesh.h"

namespace glissade {

struct SurfacePoint {
  Vector3 p;
  Vector3 normal;  ///< unit, outwards
};

/// So many points, spread evenly over the area of the mesh; the same ones each time. None where it has no area.
std::vector<SurfacePoint> surfacePoints(const TriangleMesh& mesh, std::size_t count);

}  // namespace glissade
