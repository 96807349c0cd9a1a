#pragma once

#include <vector>

#include "engine/files/assembly_edits.h"

namespace glissade {

/// An end of the motion that was moved clear of the bodies.
struct MovedEnd {
  AssemblyItem item;
  Pose X_WB;
  double distance = 0.0;  ///< metres from its earlier position
};

/// The ends that have to move so that the object keeps `required` (metres) from all bodies there; empty if none has to.
/// Errors: InCollision if no clear position was found near an end (the location names the end); Interrupted. It takes
/// up to seconds and can run on any thread.
Result<std::vector<MovedEnd>> endsMovedClear(const LoadedScenario& scenario, double required,
                                             const StopToken& stop = {});

}  // namespace glissade
