#pragma once

#include <string>

#include "engine/base/result.h"
#include "engine/check/evidence.h"
#include "engine/check/placed_body.h"
#include "engine/check/thread.h"
#include "engine/geometry/thread_core.h"

namespace glissade::check {

/// What of a shaft is taken away as its thread.
struct ThreadDepth {
  double radius = 0.0;  ///< of its crests, metres
  double core = 0.0;    ///< radius that is left, metres
  double pitch = 0.0;   ///< metres a turn; below 0: left-handed
};

/// A thread is no deeper than a sharp one of 60 degrees (ISO 68-1: H = 0.866 P), and than 0.15 of the diameter: M1.6
/// has 0.13, larger sizes less.
bool isThreadDepth(const ThreadDepth& depth);

/// The shaft and the body with the hole of a thread where they are assembled, with what the evidence gives for either.
struct ThreadSides {
  const PlacedBody& shaft;
  const PlacedBody& hole;
  const AllowanceBound& ofShaft;
  const AllowanceBound& ofHole;
};

/// The core that a shaft may be taken to be, world frame: what the faces of the hole that are in the fit leave, less
/// deflections, spacing and margin. Errors say why the shaft may not be taken so.
Result<ThreadCore> threadCoreOf(const ThreadSides& sides, const Thread& thread);

}  // namespace glissade::check
