#pragma once

#include <cstddef>
#include <optional>

#include "engine/geometry/triangle_mesh.h"

namespace glissade {

/// A surface that was closed at its T-junctions.
struct ClosedAtTJunctions {
  TriangleMesh mesh;
  std::size_t edges = 0;  ///< that were divided
  double moved = 0.0;     ///< metres that the surface has moved, at most
};

/// Divides edges on which vertices of neighbouring faces lie, as where one face was divided more finely than the next.
/// Vertices count that are at most 2 micrometres off the edge, and at most a thousandth of its length. Nothing where
/// the surface is closed already, or is not closed then. The mesh must be welded.
std::optional<ClosedAtTJunctions> closedAtTJunctions(const TriangleMesh& mesh);

}  // namespace glissade
