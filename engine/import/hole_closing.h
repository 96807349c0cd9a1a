#pragma once

#include <cstddef>

#include "engine/geometry/triangle_mesh.h"

namespace glissade {

/// A mesh with covered holes.
struct ClosedHoles {
  TriangleMesh mesh;
  std::size_t closed = 0;  ///< number of planar holes that were covered
  std::size_t left = 0;    ///< other holes, holes that meet in a vertex, possible rings
};

/// Covers each hole whose edge is planar, within a ten-thousandth of its size, with triangles between the vertices of
/// the edge. Vertices are neither added nor moved. Precondition: the mesh is welded, and its triangles are oriented
/// alike.
ClosedHoles withPlanarHolesClosed(const TriangleMesh& mesh);

}  // namespace glissade
