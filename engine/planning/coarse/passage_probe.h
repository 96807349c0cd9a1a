#pragma once

#include "engine/collision/collision_query.h"
#include "engine/environment/environment_model.h"

namespace glissade {

struct ProbeResult {
  bool passes = false;
  std::uint64_t randomConfigurations = 0;
};

/// A short bidirectional search through a passage, for objects that pass only by tilting: from before
/// it to behind it, the trial configuration turned as `inside` is. Always the same for the same
/// passage and object. A stop ends it: nothing passes then.
ProbeResult probePassage(const EnvironmentModel& environment, std::size_t place, const CollisionWorldPtr& world,
                         const Box3& bounds, const Pose& inside, const StopToken& stop = {});

}  // namespace glissade
