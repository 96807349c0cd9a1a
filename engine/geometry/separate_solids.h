#pragma once

#include <cstddef>

#include "engine/geometry/triangle_mesh.h"

namespace glissade {

/// How many closed surfaces that are turned outwards the mesh has, where those that touch each other count as one: the
/// solids of a part that hang together nowhere. Hollows inside of a solid count for nothing. They touch where
/// their surfaces are no farther from each other than this. Metres.
std::size_t separateSolids(const TriangleMesh& mesh, double touching);

}  // namespace glissade
