#pragma once

#include <array>
#include <vector>

#include "engine/geometry/triangle_mesh.h"
#include "engine/geometry/triangle_pair.h"

namespace glissade::check {

/// Ends of the edges at which a surface is open: with one triangle, or with triangles that do not agree on an outside.
/// Vertices are told apart by their numbers.
std::vector<std::array<Vector3, 2>> openEdgesOf(const std::vector<Vector3>& points,
                                                const std::vector<TriangleIndices>& triangles);

/// No open edge is nearer to a face with an allowance than nine times the largest allowance.
bool areFar(const std::vector<std::array<Vector3, 2>>& openEdges, const std::vector<Triangle>& faces,
            const std::vector<double>& allowances);

/// An open surface, and the faces of it that have moved inwards.
struct MovedSurface {
  const std::vector<TriangleIndices>& triangles;
  const std::vector<Triangle>& before;
  const std::vector<Triangle>& after;
  const std::vector<Vector3>& normals;  ///< outwards, of the faces before; zero of those with next to no area
};

/// What has moved is behind the surface: the way of each face's middle meets no other face, and from the face that has
/// moved farthest, of each connected piece, at least seven of ten directions meet the surface from within. The judge's
/// own rule; slow and simple.
bool isBehind(const MovedSurface& surface);

}  // namespace glissade::check
