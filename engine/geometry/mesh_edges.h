#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "engine/geometry/triangle_mesh.h"

namespace glissade {

/// Properties of the edges of a mesh. Vertices are distinguished by their indices.
struct EdgeFacts {
  std::size_t open = 0;              ///< edges with one triangle, or an odd number
  bool consistentlyOriented = true;  ///< each edge is used as often in one direction as in the other
};

EdgeFacts edgeFactsOf(const TriangleMesh& mesh);

/// The edges that are not used equally often in both directions, by their vertices: open edges, and edges between
/// triangles with inconsistent orientation.
std::vector<std::pair<std::uint32_t, std::uint32_t>> unpairedEdgesOf(const TriangleMesh& mesh);

}  // namespace glissade
