#pragma once

#include <vector>

#include "engine/base/result.h"
#include "engine/base/work_watch.h"
#include "engine/geometry/triangle_mesh.h"

namespace glissade {

/// The volume that a body covers while it moves.
struct SweptVolume {
  TriangleMesh surface_W;  ///< closed; contains every point of the body at every time of the motion
  double bound = 0.0;      ///< metres: upper bound on the distance of the surface's points from the body at its nearest
  double volume = 0.0;     ///< volume that the surface encloses, cubic metres
  /// Estimated excess of the volume over the covered volume with its cavities, as a share of the latter. Infinite if
  /// the body is too thin for an estimate.
  double excess = 0.0;
};

/// The swept volume of a body along straight motions between consecutive poses X_WB. Conservative: it contains the
/// sweep, and cavities that the sweep closes off. `bound`: metres, above 0; that of the result may be less.
///
/// Clearances of the body at the points of a lattice (sweepClearances) are radii of balls that the body never enters.
/// The surface is drawn so that such balls cover everything outside of it (enclosingValues). Unlike the usual
/// construction (Abdel-Malek et al. 2006: envelopes), it makes no swept surfaces, so that a motion may turn and come
/// back.
///
/// Errors: no pose, a mesh without triangles, a bound that needs more than 4 GiB or is finer than 32-bit coordinates
/// (LimitReached, with the least possible bound), a stop (Interrupted).
Result<SweptVolume> sweptVolume(const TriangleMesh& body, const std::vector<Pose>& path, double bound,
                                const WorkWatch& watch = {});

/// Chooses the bound so that the volume exceeds the covered volume by a few percent, and the surface is fine enough for
/// display; the bound is larger if that would take too many triangles or too much memory. It is found with coarser
/// surfaces, which take a fraction of the time.
Result<SweptVolume> usualSweptVolume(const TriangleMesh& body, const std::vector<Pose>& path,
                                     const WorkWatch& watch = {});

}  // namespace glissade
