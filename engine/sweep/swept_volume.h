#pragma once

#include <vector>

#include "engine/base/result.h"
#include "engine/base/work_watch.h"
#include "engine/geometry/triangle_mesh.h"

namespace glissade {

/// What a body covers while it moves.
struct SweptVolume {
  TriangleMesh surface_W;  ///< closed; contains every point of the body at every time of the motion
  double bound = 0.0;      ///< metres: no point of the surface is farther from the body at its nearest
  double volume = 0.0;     ///< of what the surface encloses, cubic metres
  /// Estimate: by which share of the volume covered, with cavities that are closed off, the volume is larger. Infinite
  /// where the body is too thin for an estimate.
  double excess = 0.0;
};

/// The swept volume of a body along straight motions between consecutive poses X_WB. Conservative: it contains the
/// sweep, and cavities that are closed off by the sweep. `bound`: metres, above 0; that of the result may be less.
///
/// Clearances of the body at the points of a lattice (sweepClearances) are radii of balls that the body never enters.
/// The surface is drawn so that such balls cover all outside of it (enclosingValues). Deviation from the usual
/// construction (Abdel-Malek et al. 2006: envelopes): no swept surfaces are made, so that a motion may turn and come
/// back.
///
/// Errors: no pose, a mesh without triangles, a bound that needs more than 4 GiB or is finer than 32-bit coordinates
/// are (LimitReached, with the least possible bound), a stop (Interrupted).
Result<SweptVolume> sweptVolume(const TriangleMesh& body, const std::vector<Pose>& path, double bound,
                                const WorkWatch& watch = {});

/// The same with a bound with which the volume is a few percent larger than what is covered, and the surface is fine
/// enough to look at; larger where that would take too many triangles or too much memory. It is found with coarser
/// surfaces, which take a fraction of the time.
Result<SweptVolume> usualSweptVolume(const TriangleMesh& body, const std::vector<Pose>& path,
                                     const WorkWatch& watch = {});

}  // namespace glissade
