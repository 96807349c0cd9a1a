#pragma once

#include <vector>

#include "engine/base/work_watch.h"
#include "engine/sweep/lattice.h"
#include "engine/sweep/sweep_clearances.h"

namespace glissade {

/// Values at the points of a lattice whose surface of level 0 (levelSurface) encloses all that the body passes, and
/// cavities that this closes off; and which points the body leaves free, connected with the rim of the lattice.
struct EnclosingValues {
  std::vector<float> values;  ///< metres; above 0 outside
  std::vector<bool> outside;
};

/// A clearance is the radius of a ball that the body never enters. Values are first the clearance outside and the depth
/// below the balls inside. Then each tetrahedron is certified: one of the balls holds all of its part outside the
/// surface. Where none does, the values at its corners are lowered until one does. Lowering them by the same number
/// moves the surface outwards, also where another tetrahedron asks for more, so that one pass is enough.
///
/// Unfinished after a stop.
EnclosingValues enclosingValues(const Lattice& lattice, const SweepClearances& clearances, const WorkWatch& watch);

}  // namespace glissade
