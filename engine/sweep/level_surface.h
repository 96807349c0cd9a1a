#pragma once

#include <vector>

#include "engine/geometry/triangle_mesh.h"
#include "engine/sweep/lattice.h"

namespace glissade {

/// The surface on which values at the points of a lattice, interpolated linearly in tetrahedra, have a level. It is
/// closed, with the smaller values inside. Each cell is divided into six tetrahedra about its diagonal (marching
/// tetrahedra, Doi and Koide 1991; the division is Kuhn's), which match those of the neighbours.
/// Precondition: values on the rim of the lattice are above the level.
TriangleMesh levelSurface(const Lattice& lattice, const std::vector<float>& values, float level);

}  // namespace glissade
