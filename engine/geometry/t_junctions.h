#pragma once

#include <cstddef>
#include <optional>

#include "engine/geometry/triangle_mesh.h"

namespace glissade {

/// A surface that was closed by dividing edges at T-junctions.
struct ClosedAtTJunctions {
  TriangleMesh mesh;
  std::size_t edges = 0;  ///< number of divided edges
  double moved = 0.0;     ///< largest motion of the surface, metres
};

/// Divides edges on which vertices of neighbouring faces lie, which occurs where one face was divided more finely than
/// the next. A vertex counts if it is at most 2 micrometres off the edge, and at most a thousandth of the edge's
/// length. Nothing where the surface is closed already, or is not closed afterwards. Precondition: the mesh is welded.
std::optional<ClosedAtTJunctions> closedAtTJunctions(const TriangleMesh& mesh);

}  // namespace glissade
