#pragma once

#include "engine/geometry/triangle_mesh.h"
#include "engine/sweep/lattice.h"
#include "engine/sweep/sweep_clearances.h"

namespace glissade {

/// No point of a surface through the cells of a lattice is farther from the body, at its nearest, than this; metres.
/// Precondition: each triangle has a corner of the lattice near it at which the clearance is below the reach.
double farthestFromBody(const TriangleMesh& surface_W, const Lattice& lattice, const SweepClearances& clearances);

}  // namespace glissade
