#pragma once

#include <cstddef>

#include "engine/geometry/triangle_mesh.h"

namespace glissade {

/// The number of solids of a mesh that do not touch each other. A solid is a connected surface with a positive volume;
/// hollows inside of a solid do not count. Solids whose surfaces are no farther apart than `touching`, in metres, are
/// one.
std::size_t separateSolids(const TriangleMesh& mesh, double touching);

}  // namespace glissade
