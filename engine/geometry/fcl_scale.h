#pragma once

#include <vector>

#include "engine/geometry/triangle_mesh.h"

namespace glissade {

/// The power of two by which geometry is multiplied before FCL sees it. FCL 0.7 compares lengths and squared areas with
/// absolute constants: TriangleDistance skips the faces of triangles whose squared area is below 1e-15 m^4, and the
/// distance of boxes (RSS) is off below 1e-7 m. The scale gives the smallest triangle with an area an area near one. A
/// power of two changes no digit of any coordinate. `farthest`: the largest coordinate of a mesh's position, metres.
double fclScale(const std::vector<const TriangleMesh*>& meshes, double farthest);

/// Largest absolute coordinate of a vertex; 0 where there is none.
double largestCoordinate(const TriangleMesh& mesh);

}  // namespace glissade
