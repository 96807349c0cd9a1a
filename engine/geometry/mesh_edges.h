#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "engine/geometry/triangle_mesh.h"

namespace glissade {

/// How the triangles of a mesh meet at its edges. Vertices are told apart by their numbers.
struct EdgeFacts {
  std::size_t open = 0;              ///< edges with one triangle, or an uneven number
  bool consistentlyOriented = true;  ///< each edge is used as often in one direction as in the other
};

EdgeFacts edgeFactsOf(const TriangleMesh& mesh);

/// The edges that are not used as often in one direction as in the other, by their vertices: open ones, and those
/// between triangles that do not agree on an outside.
std::vector<std::pair<std::uint32_t, std::uint32_t>> unpairedEdgesOf(const TriangleMesh& mesh);

}  // namespace glissade
