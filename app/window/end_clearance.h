#pragma once

#include <vector>

#include "engine/scenario/assembly_edits.h"

namespace glissade {

/// An end of the motion that was moved clear of the bodies.
struct MovedEnd {
  AssemblyItem item;
  Pose X_WB;
  double distance = 0.0;  ///< metres from where it was
};

/// The ends that have to move so that the object keeps `required` (metres) from all bodies there; empty: none has to.
/// Errors: InCollision, no clear position was found near an end, which the location names; Interrupted. Takes up to
/// seconds; any thread.
Result<std::vector<MovedEnd>> endsMovedClear(const LoadedScenario& scenario, double required,
                                             const StopToken& stop = {});

}  // namespace glissade
