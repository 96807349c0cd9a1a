#pragma once

#include <cstddef>

#include "engine/geometry/triangle_mesh.h"

namespace glissade {

/// How the triangles of a mesh meet at its edges. Vertices are told apart by their numbers.
struct EdgeFacts {
  std::size_t open = 0;              ///< edges with one triangle, or an uneven number
  bool consistentlyOriented = true;  ///< each edge is used as often in one direction as in the other
};

EdgeFacts edgeFactsOf(const TriangleMesh& mesh);

}  // namespace glissade
