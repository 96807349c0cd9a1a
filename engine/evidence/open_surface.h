#pragma once

#include <array>
#include <vector>

#include "engine/geometry/triangle_mesh.h"
#include "engine/geometry/triangle_pair.h"

namespace glissade::evidence {

/// Ends of the edges at which a surface is open: edges with one triangle, or with triangles of different orientation.
/// Vertices are identified by their numbers.
std::vector<std::array<Vector3, 2>> openEdgesOf(const std::vector<Vector3>& points,
                                                const std::vector<TriangleIndices>& triangles);

/// True if each open edge is farther from the faces with an allowance than nine times the largest allowance.
bool areFar(const std::vector<std::array<Vector3, 2>>& openEdges, const std::vector<Triangle>& faces,
            const std::vector<double>& allowances);

/// An open surface, with the faces that have moved inwards.
struct MovedSurface {
  const std::vector<TriangleIndices>& triangles;
  const std::vector<Triangle>& before;
  const std::vector<Triangle>& after;
  const std::vector<Vector3>& normals;  ///< outward normals of `before`; zero for faces with next to no area
};

/// True if the moved faces are behind the surface: the displacement of each face's centre meets no other face, and from
/// the face of each connected group that has moved farthest, at least seven of ten directions meet the surface from
/// within. The judge's rule, independent of the planners; slow and simple.
bool isBehind(const MovedSurface& surface);

}  // namespace glissade::evidence
