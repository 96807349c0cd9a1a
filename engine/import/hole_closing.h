#pragma once

#include <cstddef>

#include "engine/geometry/triangle_mesh.h"

namespace glissade {

/// A mesh with more triangles.
struct ClosedHoles {
  TriangleMesh mesh;
  std::size_t closed = 0;  ///< holes that were planar
  std::size_t left =
      0;  ///< others; those that meet in a vertex; those in one plane that may be the two edges of a ring
};

/// Covers each hole whose edge is in a plane, within a ten-thousandth of its size, with triangles between the vertices
/// of the edge; no vertex is new or moves. Precondition: the mesh is welded, and neighbours run the same way round.
ClosedHoles withPlanarHolesClosed(const TriangleMesh& mesh);

}  // namespace glissade
