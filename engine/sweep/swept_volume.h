#pragma once

#include <vector>

#include "engine/base/result.h"
#include "engine/base/stop_token.h"
#include "engine/geometry/triangle_mesh.h"

namespace glissade {

/// What a body covers while it moves.
struct SweptVolume {
  TriangleMesh surface_W;  ///< closed; contains every point of the body at every time of the motion
  double bound = 0.0;      ///< metres: no point of the surface is farther from the body at its nearest
  double volume = 0.0;     ///< of what the surface encloses, cubic metres
};

/// A bound that is fine enough to look at and quick to reach: a two-hundredth of the diagonal of the body's box, or
/// more where the motion is so long, or the body so bulky, that this would take too much memory. Metres.
double usualSweepBound(const TriangleMesh& body, const std::vector<Pose>& path);

/// The swept volume of a body along straight motions between consecutive poses X_WB. Conservative: it contains the
/// sweep, and cavities that are closed off by the sweep. `bound`: metres, above 0; computing time grows with its
/// inverse to the fourth power.
///
/// Distances from the body's surface are sampled once, then lowered into a lattice of the world at poses so near that
/// no point moves farther than half a spacing between a time and a pose; the surface is where the lattice's distances
/// are as large as all errors together. Deviation from the usual construction (Abdel-Malek et al. 2006: envelopes): no
/// swept surfaces are made, so that a motion may turn and come back.
///
/// Errors: no pose, a mesh without triangles, a bound that needs more than 4 GiB or is finer than 32-bit coordinates
/// are (LimitReached, with the least possible bound), a stop (Interrupted).
Result<SweptVolume> sweptVolume(const TriangleMesh& body, const std::vector<Pose>& path, double bound,
                                const StopToken& stop = {});

}  // namespace glissade
