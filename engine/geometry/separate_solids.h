#pragma once

#include <cstddef>

#include "engine/geometry/triangle_mesh.h"

namespace glissade {

/// How many closed surfaces that are turned outwards the mesh has, where those that touch each other count as one: the
/// solids of a part that hang together nowhere. Hollows inside of a solid count for nothing. They touch where a vertex
/// of the one is no farther from the other than this. Metres.
std::size_t separateSolids(const TriangleMesh& mesh, double touching);

}  // namespace glissade
